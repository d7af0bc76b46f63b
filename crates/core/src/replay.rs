//! A long search that runs in parts: what has been computed is kept, and the search starts again from it.

use std::cell::{Cell, RefCell};

/// The answers of a deterministic search so far, in the order in which they were asked for.
///
/// A search asks for every expensive value through [`Replay::value`]. When the budget of a part is spent, the remaining values are
/// NaN, so that the search ends at once; its result is then discarded, and the next part runs the same search again, which takes
/// all known values from here.
#[derive(Clone, Debug, Default)]
pub struct Replay {
    known: RefCell<Vec<f64>>,
    next: Cell<usize>,
    budget: Cell<usize>,
    short: Cell<bool>,
}

impl Replay {
    /// Runs a search from its start with a budget: the number of values that may be computed afresh. Returns `None` when that does
    /// not suffice; the search may then be run again.
    pub fn run<T>(&mut self, budget: usize, search: impl FnOnce(&Self) -> T) -> Option<T> {
        self.next.set(0);
        self.budget.set(budget);
        self.short.set(false);
        let found = search(self);
        (!self.short.get()).then_some(found)
    }

    /// Runs a search in one part.
    pub fn whole<T>(search: impl FnOnce(&Self) -> T) -> T {
        let replay = Self { budget: Cell::new(usize::MAX), ..Self::default() };
        search(&replay)
    }

    /// True once the budget is spent: the result of this run will be discarded.
    #[must_use]
    pub fn is_short(&self) -> bool {
        self.short.get()
    }

    /// A value of the search: known from the run before, or computed; NaN when the budget is spent.
    pub fn value(&self, compute: impl FnOnce() -> f64) -> f64 {
        let [value] = self.values(|| [compute()]);
        value
    }

    /// An answer of the search: known from the run before, or computed; false when the budget is spent.
    pub fn holds(&self, compute: impl FnOnce() -> bool) -> bool {
        self.value(|| f64::from(u8::from(compute()))) == 1.0
    }

    /// Several values that are computed together.
    pub fn values<const N: usize>(&self, compute: impl FnOnce() -> [f64; N]) -> [f64; N] {
        if self.short.get() {
            return [f64::NAN; N];
        }
        let first = self.next.get();
        let known = self.known.borrow().get(first..first + N).map(|known| std::array::from_fn(|i| known[i]));
        if let Some(known) = known {
            self.next.set(first + N);
            return known;
        }
        if self.budget.get() == 0 {
            self.short.set(true);
            return [f64::NAN; N];
        }
        self.budget.set(self.budget.get() - 1);
        let values = compute();
        self.known.borrow_mut().extend(values);
        self.next.set(first + N);
        values
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_search_in_parts_finds_what_it_finds_in_one_and_computes_nothing_twice() {
        let computed = Cell::new(0);
        let search = |replay: &Replay| {
            let value = |x: f64| {
                replay.value(|| {
                    computed.set(computed.get() + 1);
                    x * x
                })
            };
            (1..=10).map(|x| value(f64::from(x))).sum::<f64>()
        };
        assert_eq!(Replay::whole(search), 385.0);
        computed.set(0);
        let mut replay = Replay::default();
        let parts: Vec<Option<f64>> = (0..4).map(|_| replay.run(3, search)).collect();
        assert_eq!((parts, computed.get()), (vec![None, None, None, Some(385.0)], 10));
    }
}
