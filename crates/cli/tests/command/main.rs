//! The command as programs and people use it: what goes in, what comes out, and how it ends.

mod analyze;
mod auto;
mod check;
mod compare;
mod convert;
mod edit;
mod errors;
mod export;
mod licenses;
mod links;
mod run;
mod solve;
mod wedge;
