/** The shapes that cross between the page's modules, and those of the engine as it is seen from here. */

export type Language = "en" | "es";
/** A span is a part of β, in its unit; its default is a part of 1. */
export type Quantity = "length" | "angle" | "ratio" | "span" | "height";
export type Diagram = "s" | "v" | "a" | "j" | "pressure_angle" | "rho" | "contact";
export type ColumnName = "theta" | Diagram | "rho_pitch" | "x" | "y" | "pitch_x" | "pitch_y" | "outer_x" | "outer_y";
export type KindId = "rotating" | "grooved" | "constant-breadth" | "translating";
export type Generator = "harmonic" | "circular-arc" | "mirror";
export type TieKey = "distance" | "angle" | "base_radius";

export interface Parameter {
  key: string;
  symbol: string;
  quantity: Quantity;
  default: number | null;
  optional: boolean;
}

export interface LawEntry {
  id: string;
  group: "basic" | "standard" | "half" | "matched" | "free";
  /** False for a law that keeps the height. */
  moves: boolean;
  parameters: Parameter[];
  /** Acceleration at even steps of the segment, scaled to −1…1. */
  thumbnail: number[];
  /** The field that the law is made from, and what it starts with over β = 1 from 0 to 1. */
  free: { key: string; first: FreeData } | null;
}

/** A value of s, v, a or j (order 0 to 3) at a place in a segment, degrees from its start. */
export interface Condition {
  at: number;
  order: number;
  value: number;
}

export type Conditions = Condition[];

/** A place in a segment, degrees from its start, and s there. */
export type Point = [number, number];

/** Conditions, points of a table, ordinates or an expression. */
export type FreeData = Conditions | Point[] | number[] | string;

export interface FollowerEntry {
  id: string;
  motion: Motion;
  contact: Contact;
  parameters: Parameter[];
}

export type Motion = "translating" | "oscillating";
export type Contact = "roller" | "knife" | "curved" | "flat";

/** An entry of the examples library. */
export interface Example {
  id: string;
  group: "classic" | "solved" | "more";
  design: Design;
  en: { title: string; note: string };
  es: { title: string; note: string };
}

/** Everything the forms are built from, so that a new law or follower appears by itself. */
export interface Catalogue {
  laws: LawEntry[];
  followers: FollowerEntry[];
  /** Kinds of cam, each with the followers that have a place on it. */
  kinds: { id: KindId; followers: string[] }[];
  generators: Generator[];
  /** Polygons of arcs, with the least base radius (sharp corners) for a breadth of 1. */
  polygons: { sides: number; least: number }[];
  length_units: string[];
  speed_units: string[];
  /** The design that the page opens with. */
  first: Design;
  limits: { segments: number; title: number; link: number };
}

export interface Follower {
  motion: string;
  contact: string;
  [parameter: string]: number | string;
}

export interface Segment {
  law: string;
  beta: number;
  /** Not told where the law's own data say where it ends. */
  rise?: number;
  conditions?: Conditions;
  /** Of a spline, from the segment's start; the engine's own when they are not told. */
  knots?: number[];
  points?: Point[];
  ordinates?: number[];
  expression?: string;
  [parameter: string]: number | FreeData | undefined;
}

/** The design file as a plain object; its version is that of the last read, and counts for nothing here. */
export interface Design {
  format: "levalab/1" | "levalab/2";
  title: string;
  length_unit: string;
  speed: { value: number; unit: string };
  cam: CamDesign;
  follower: Follower;
  /** The second cam: tied by one of the three, with the radius of its own disc. */
  conjugate?: Partial<Record<TieKey | "roller_radius" | "face_radius", number>>;
  /** What the follower drives. */
  application?: ApplicationDesign;
  /** Whose symbols it is told in; ours when left out. */
  notation?: string;
  /** Empty when the motion is ready-made. */
  segments: Segment[];
}

/** Something attached to a follower that slides; its parameters by their keys. */
export interface ApplicationDesign {
  kind: string;
  /** Which output the targets are of; the first when left out. */
  output?: string;
  by?: "theta" | "time";
  /** Place and value of each. */
  targets?: [number, number][];
  [parameter: string]: string | number | [number, number][] | undefined;
}

/** A parameter, an output or a figure of an application. */
export interface ApplicationMagnitude {
  id: string;
  symbol: string;
  name: string;
  unit: string;
  /** The usual value of a parameter, the value of a figure. */
  value: number | null;
}

/** An application as a menu offers it. */
export interface ApplicationEntry {
  id: string;
  title: string;
  parameters: ApplicationMagnitude[];
  outputs: ApplicationMagnitude[];
}

export interface ApplicationOutput extends Range {
  id: string;
  symbol: string;
  name: string;
  unit: string;
  min: number;
  max: number;
  /** What a cycle delivers, of an output that works by strokes. */
  per_cycle: number | null;
  per_second: number | null;
}

/** A point to hit, and what is there. */
export interface ApplicationTarget {
  theta: number;
  time: number;
  value: number;
  found: number;
  error: number;
}

export interface ApplicationReport {
  /** Which output the targets are of. */
  main: number;
  outputs: ApplicationOutput[];
  figures: ApplicationMagnitude[];
  targets: ApplicationTarget[];
}

/** A design's application at work. */
export interface Driven {
  report(language: Language): ApplicationReport;
  /** Every output at a place of the cursor. */
  at(place: number): Float64Array;
  draw(canvas: HTMLCanvasElement, output: number, style: ChartStyle): PlotArea;
  svg(output: number, style: ChartStyle): string;
  free(): void;
}

export interface CamDesign {
  kind: KindId;
  rotation?: Rotation;
  /** None for a cam that travels. */
  base_radius?: number;
  breadth?: number;
  generator?: Generator;
  sides?: number;
  length?: number;
}

/** A good tie for a second cam, and between which values it has its place; no greatest for a distance. */
export interface Room {
  value: number;
  least: number;
  most: number | null;
}

export type Rotation = "counterclockwise" | "clockwise";

/** A piece of the worked solution: text, or a tag with its attributes (name and value by turns) and what it holds. */
export type SolutionNode = string | [tag: string, attributes: string[], ...children: SolutionNode[]];

/** What is wrong with a design and where, told in the language of the page. */
export interface DesignError {
  path: string;
  message: string;
}

export interface ChartStyle {
  width: number;
  height: number;
  pixel_ratio: number;
  font: string;
  font_size: number;
  ink: string;
  muted: string;
  grid: string;
  background: string;
  curve: string;
  limit: string;
  mark: string;
  dash: number[];
  /** Shows the ends of a face that is so much longer at each end than the contact needs. */
  margin?: number;
  stroke: number;
  /** Derivatives by time; of an application, drawn against time. */
  per_second: boolean;
  x_labels: boolean;
  decimal_comma: boolean;
}

export interface PlotArea {
  left: number;
  top: number;
  width: number;
  height: number;
  x_min: number;
  x_max: number;
  y_min: number;
  y_max: number;
}

export interface Range {
  min: number | null;
  min_at: number;
  max: number | null;
  max_at: number;
}

/** Edits that make the β's add up, or the heights come back. */
export type Completion = "fill-with-dwell" | "fill-with-return" | "stretch-last" | "spread" | "close";

/** A change of a design; `docs/edits.md` tells what each does. Segments are counted from 0. */
export type Edit =
  | { path: (string | number)[]; value: unknown }
  | { op: "clear"; path: (string | number)[] }
  | { op: "insert"; at: number; from?: number }
  | { op: "duplicate"; segment: number }
  | { op: "delete"; segments: number[] }
  | { op: "move"; from: number; to: number }
  | { op: "law"; segment: number; law: string }
  | { op: "beta"; segment: number; value: number }
  | { op: Completion | "new" }
  | { op: "scale"; factor: number }
  | { op: "condition"; segment: number; at: number; order: number; value: number }
  | { op: "add-condition"; segment: number }
  | { op: "move-conditions"; segment: number; from: number; to: number }
  | { op: "drop-conditions"; segment: number; at: number; order?: number }
  | { op: "formula"; segment: number; text: string }
  | { op: "follower"; follower: string }
  | { op: "kind"; kind: KindId; before?: Design; after?: Design }
  | { op: "generator"; generator: Generator; sides?: number }
  | { op: "pair"; tie: TieKey; value?: number }
  | { op: "application"; application?: string }
  | { op: "targets-by"; by: "theta" | "time" }
  | { op: "convert" | "relabel"; unit: string };

/** The program of a design, whether or not it makes a cam; heights are above the base circle. */
export interface Outline {
  /** What the β's must add up to. */
  whole: number;
  /** What is left of it; negative where they add up to more. */
  left: number;
  /** How far the program ends above where it should. */
  open: number;
  /** The height at each border, and the rise between two. */
  heights: number[];
  rises: number[];
  lift: number;
  /** How far the follower of a cam of constant breadth travels. */
  travel: number | null;
  /** Whether the last segment can take what is left, or give back what is too much. */
  stretches: boolean;
  /** Whether a segment can take the height that is open. */
  closes: boolean;
}

export interface Cure {
  message: string;
  edits: Edit[];
}

export interface Finding {
  /** Which cam of a pair, 1 or 2. */
  cam?: number;
  code: string;
  severity: Level;
  theta: number;
  interval: [number, number] | null;
  places: number[];
  value: number | null;
  limit: number | null;
  message: string;
  /** The sentence with derivatives with respect to time, where it differs. */
  message_by_time?: string;
}

export type Level = "acceptable" | "low-speed" | "unacceptable";

export interface Report {
  /** The fragment without `#`; empty when the design is too long for a link. */
  link: string;
  kind: KindId;
  /** What the cursor runs through: 360°, or the length of a cam that travels. */
  span: number;
  travels: boolean;
  /** On both cams of a pair; `cam` is whose headline it is. */
  verdict: { level: Level; headline: string; cam?: number; findings: Finding[] };
  summary: Partial<Record<Diagram | "V" | "A" | "J" | "rho_pitch" | "breadth", Range>>;
  /** The sharpest convex place of the profile; null where nothing is convex. */
  least_convex: { value: number; at: number } | null;
  /** The tightest hollow, as a negative ρ; null where nothing is hollow. */
  tightest_hollow: { value: number; at: number } | null;
  /** θ of every inflection of the profile, where it passes from convex to hollow or back. */
  inflections: number[];
  joints: { theta: number; segment: number; jump: "s" | "v" | "a" | "j" | null }[];
  borders: number[];
  /** The segments of a motion that is ready-made. */
  program: { law: string; beta: number; rise: number }[] | null;
  /** s at the borders. */
  heights: number[];
  omega: number;
  period: number;
  /** Largest pressure angle that the follower tolerates, in degrees. */
  pressure_angle_limit: number;
  mechanism: {
    sense: 1 | -1;
    base_radius: number;
    prime_radius: number | null;
    motion: string;
    contact: string;
    roller_radius: number;
    eccentricity: number;
    pivot: [number, number] | null;
    arm: number | null;
    /** ξ₀ in degrees, of a follower that swings. */
    opening: number | null;
    face_offset: number;
    face_angle: number;
    face: [number, number] | null;
    /** The minimum length of a flat face, from the foot of the pivot when it swings. */
    face_length: number | null;
    reach: number;
    top: number;
  };
  units: { s: string; v: string; a: string; j: string; V: string; A: string; J: string; u: string; U: string; length: string };
  /** The second cam of a pair, in the frame of the first. */
  conjugate: Report | null;
  /** Angle between the arms of a pair that swings, degrees. */
  pair_angle: number | null;
  /** Both profiles of a pair are one, in a sentence. */
  pair_note?: string;
  /** Symbols other than ours, by ours, and the sign with which an eccentricity is told. */
  notation?: { symbols: Record<string, string>; eccentricity: number };
}

export type Opened = ({ report: Report; error?: undefined } | { error: DesignError; report?: undefined }) & { outline: Outline | null };
/** What an address holds: nothing at all when there is no link in it. */
export interface OpenedLink {
  design?: Design;
  /** What is to be said about how the link came. */
  note?: string;
  error?: DesignError;
}

/** Pairs of numbers of a text, or the line, from 1, that is none. */
export type Pairs = { points: Point[]; line?: undefined } | { line: number; points?: undefined };

/** What the text of a table says: its points, or how many lines of measured data it has, of which columns and points are to be chosen. */
export type TableText = { points: Point[]; measured?: undefined; error?: undefined } | { measured: number; points?: undefined; error?: undefined } | { error: DesignError; points?: undefined; measured?: undefined };

/** What is asked of measured data: columns, and a number of points or a residual. */
export interface MeasuredOrder {
  angle?: number;
  lift?: number;
  count?: number | undefined;
  within?: number | undefined;
}

/** What a text of measured data holds, and what is taken of it. */
export interface Measured {
  /** Columns of numbers. */
  columns: { index: number; heading: string; unit: string; sample: number[] }[];
  angle: number;
  lift: number;
  /** Points of the whole curve, and the most that may be taken. */
  all: number;
  most: number;
  points: Point[];
  /** The largest of curve − point, and where. */
  residual: number;
  at: number;
  note: string;
  error?: DesignError;
}

export type Read = { design: Design; error?: undefined } | { error: DesignError; design?: undefined };

/** A file that is wanted of the module for exports; lengths in the unit of the design. */
export interface ExportOrder {
  to: "csv" | "xlsx" | "dxf" | "svg" | "stl";
  /** Degrees between rows or points. */
  step?: number;
  table?: string;
  separator?: "comma" | "semicolon";
  /** A diagram instead of the cam. */
  diagram?: string;
  per_second?: boolean;
  /** Paper that the cam has to fit on, mm. */
  room?: [number, number];
  thickness?: number;
  /** Diameter of the hole for the shaft. */
  bore?: number;
  /** Width and depth. */
  keyway?: [number, number];
}

export type Exported = { bytes: Uint8Array; error?: undefined } | { error: string; bytes?: undefined };

/** The engine's one object: the current cam. */
export interface Lab {
  free(): void;
  open(design: Design, samples: number, language: Language): Opened;
  /** What would cure each finding of the current cam, and of the second one, in their order. Slower than an analysis: for when the hand rests. */
  cures(language: Language): Cure[][];
  /** Goes on with the search for the cures; `budget` is the number of looks at a cam that this part may take. Undefined while it is not done. */
  step_cures(budget: number, language: Language): Cure[][] | undefined;
  column(name: ColumnName, second?: boolean): Float64Array;
  at(theta: number, out: Float64Array, second?: boolean): void;
  /** s, v, a, j before and after border `border` (0 is θ = 0): eight numbers, per radian; none without a cam. */
  limits(border: number): Float64Array;
  draw(canvas: HTMLCanvasElement, diagram: Diagram, style: ChartStyle, second?: boolean): PlotArea;
  svg(diagram: Diagram, style: ChartStyle, second?: boolean): string;
  /** Draws this cam alone from now on. */
  alone(): void;
  /** Draws the cam of another laboratory behind this one's from now on. */
  beside(other: Lab, colour: string, dash: Float64Array): void;
  /** In the order of `FIGURES`; NaN where one does not apply. */
  figures(): Float64Array;
  /** Left and right end of the face that the contact needs with a margin at each end, and its length; empty without a face. */
  face(margin: number, second?: boolean): Float64Array;
}

/** What lights up in the mechanism, the diagrams and the help drawing. */
export interface Highlight {
  theta?: number;
  interval?: [number, number];
  segment?: number;
  parameter?: string;
}

export type Theme = "light" | "dark" | "system";
export type Tab = "svaj" | "pressure_angle" | "rho" | "contact";

export interface State {
  /** The design as edited, which may be wrong: then `error` is set and `stale` is true. */
  design: Design;
  /** Always that of the last good design. */
  report: Report;
  error: DesignError | null;
  stale: boolean;
  /** The program of the design as edited. */
  outline: Outline;
  /** Cam angle in degrees, 0 ≤ cursor < 360; of a cam that travels the place, 0 ≤ cursor ≤ its length. */
  cursor: number;
  playing: boolean;
  /** Turns of the animation per second, signed; 0 is a stop. */
  rate: number;
  perSecond: boolean;
  tab: Tab;
  /** Whether diagrams and readings are those of the second cam, when there is one. */
  second: boolean;
  layers: Record<string, boolean>;
  language: Language;
  theme: Theme;
  projector: boolean;
  /** Whether the projector view shows the speed of the animation. */
  projectorSpeed: boolean;
  /** Whether the projector view shows large instant values. */
  projectorValues: boolean;
  highlight: Highlight | null;
  /** What a face is longer at each end than its contact needs, by the unit of length. */
  margins: Record<string, number>;
  /** The cams that are drawn beside this one. */
  beside: readonly Beside[];
}

/** A cam drawn beside that of the design: its outline in its own frame, and its look. */
export interface Beside {
  name: string;
  outline: Path2D;
  sense: 1 | -1;
  reach: number;
  unit: string;
  colour: string;
  dash: number[];
}

/** What can change and be waited for: a part of the state, or the window on the mechanism, which that keeps to itself. */
export type Change = keyof State | "window";

export type ViewState = Omit<State, "design" | "report" | "error" | "stale" | "outline">;

export interface Store {
  readonly state: Readonly<State>;
  /** Calls `fn` once a frame when any of `keys` has changed. Returns the way out. */
  subscribe(keys: Change[], fn: (state: Readonly<State>, changed: ReadonlySet<string>) => void): () => void;
  /** Changes what is seen, not what is designed: no undo. */
  set(patch: Partial<ViewState>): void;
  /** Tells the listeners of `key` at the next frame, though nothing that is kept here has changed. */
  touch(key: Change): void;
  /**
   * Changes the design: analyses, remembers for undo (one entry a gesture), schedules a frame. What is wrong with an edit that is not
   * possible is given back, and the design stays; `told` says that whoever asked shows it.
   */
  edit(label: string, edits: Edit[], options?: { gesture?: string; told?: boolean }): DesignError | null;
  /** Takes back a gesture that is under way, as if it had never begun. */
  cancel(gesture: string): void;
  /** The gesture is over: the next edit makes its own undo step. */
  endGesture(): void;
  undo(): void;
  redo(): void;
  canUndo(): boolean;
  canRedo(): boolean;
  /** Puts another design in place; undo gives the old one back. */
  replace(design: Design, label: string): void;
}

/** `t("transport.play")`, `t("verdict.more", { count: 3 })`. */
export type Translate = (key: string, values?: Record<string, string | number>) => string;

/** What was typed as a number, or the sentence that says why it is none. */
export type NumberReading = { value: number; problem?: undefined } | { problem: string; value?: undefined };

export interface Format {
  /** `digits` decimals, or the shortest exact form without them. */
  number(value: number | null | undefined, options?: { digits?: number; unit?: string }): string;
  /** Degrees with one decimal (or `digits`) and the sign °. */
  angle(value: number | null | undefined, digits?: number): string;
  /** Four significant digits, never rounding whole digits away; `trim` drops final zeros. */
  quantity(value: number | null | undefined, options?: { trim?: boolean; unit?: string }): string;
}

/** What every module of the page is mounted with. */
export interface Context {
  store: Store;
  lab: () => Lab;
  t: Translate;
  format: Format;
}

/** What a module of the shell is mounted with besides. */
export interface ShellContext extends Context {
  store: Store & Keeper;
  catalogue: Catalogue;
  /** The room that a design leaves for a second cam, tied in one of the ways that its follower allows. */
  room: (design: Readonly<Design>, key: TieKey) => Room | null;
  /** The module of the main screen; asked for before each use, since a panic replaces it. */
  module: () => import("./engine.js").Module;
  /** The module of the rarer work; asked for before each use, likewise. */
  workshop: () => Promise<import("./workshop.js").Workshop>;
  /** Says a sentence to screen readers, politely. */
  announce: (sentence: string) => void;
  banner: Banner;
}

export interface Banner {
  /** `values` as a function are asked for again in another language. */
  show(key: string, values?: Record<string, string> | (() => Record<string, string>), raw?: string): void;
  hide(): void;
}

/** What the shell does with the store beyond what every module may. */
export interface Keeper {
  connect(wiring: Wiring): void;
  /** Opens the first design of all, without an undo step; false when it is no good. */
  start(design: Design): boolean;
  /** The same design again: after a change of language, or on a fresh engine. */
  /** Analyses the design on screen afresh, or one that is the same by another name. */
  reanalyse(design?: Design): void;
  /** The design that `state.report` is about. */
  lastGood(): Design;
  /** Another number for each design that was opened; undo goes back to the one before. */
  origin(): number;
  undoLabel(): string;
  redoLabel(): string;
  /** Draws what is pending at once. */
  drawNow(): void;
}

export interface Wiring {
  /** Gives the report of a design, or what is wrong with it. */
  analyse: (design: Design) => Opened;
  /** The design with edits made, or why one of them is not possible. */
  apply: (design: Design, edits: Edit[]) => Read;
  /** Told of an edit that is not possible, unless whoever asked for it shows why. */
  refused?: (error: DesignError, design: Design, edits: Edit[]) => void;
  /** Told when a listener throws. */
  failed?: (error: unknown) => void;
  /** requestAnimationFrame, or another in tests. */
  frame?: (draw: () => void) => void;
}
