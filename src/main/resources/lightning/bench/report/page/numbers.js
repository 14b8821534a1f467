// Numbers for people: three digits or so. Missing numbers are dashes.
const minus = (text) => text.replace("-", "−");
const special = (v) => Number.isNaN(v) ? "–" : v > 0 ? "∞" : "−∞";
const fixed = (v, digits) => minus(v.toFixed(digits));
const grouped = (v) => fixed(v, 0).replace(/\B(?=(\d{3})+$)/g, "\u202f");

// 0.123, 12.3, 1 230
function threeDigits(v) {
  const size = Math.abs(v);
  return !Number.isFinite(v) ? special(v) : size >= 1000 ? grouped(v) : fixed(v, size >= 100 ? 0 : size >= 10 ? 1 : size >= 1 ? 2 : 3);
}
const withUnit = (v, unit) => Number.isFinite(v) ? `${threeDigits(v)}\u00a0${unit}` : special(v);
const ms = (v) => withUnit(v, "ms");
const percent = (v) => Number.isFinite(v) ? `${fixed(v, 1)}\u00a0%` : special(v);
// Never 0 if the part is positive.
const share = (part, whole) => part === 0 ? "none" : part / whole < 0.0005 ? "< 0.1\u00a0%" : percent(100 * part / whole);
function bytes(v) {
  const [unit, size] = [["GB", 1e9], ["MB", 1e6], ["kB", 1e3]].find(([, least]) => Math.abs(v) >= least) || ["kB", 1e3];
  return `${fixed(v / size, 1)}\u00a0${unit}`;
}
const decibels = (v) => v === Infinity ? "∞" : Number.isFinite(v) ? withUnit(v, "dB") : "–";
const similarity = (v) => Number.isNaN(v) ? "–" : v === 1 ? "1" : fixed(v, 5);

// 10⁻⁸
const power = (exponent) => `10${String(exponent).replace(/./g, (c) => c === "-" ? "⁻" : "⁰¹²³⁴⁵⁶⁷⁸⁹"[c])}`;

// An error that may be tiny: 0, 0.12, 3.1·10⁻⁸
function error(v) {
  if (v === 0 || !Number.isFinite(v)) {
    return v === 0 ? "0" : special(v);
  }
  if (Math.abs(v) >= 0.01 && Math.abs(v) < 999.5) {
    return minus(v.toPrecision(3));
  }
  const [digits, exponent] = v.toExponential(1).split("e");
  return `${minus(digits)}·${power(Number(exponent))}`;
}

// A tick of an axis: 0.1, 5, 1 000
const tick = (v) => v >= 1000 ? grouped(v) : Number(v.toPrecision(2)).toLocaleString("en", { maximumFractionDigits: 20 });
const percentTick = (v) => `${tick(100 * v)} %`;
const powerTick = (v) => power(Math.round(Math.log10(v)));

function median(values) {
  const sorted = [...values].sort((a, b) => a - b);
  const n = sorted.length;
  return n === 0 ? NaN : (sorted[(n - 1) >> 1] + sorted[n >> 1]) / 2;
}
const mean = (values) => values.length === 0 ? NaN : values.reduce((a, b) => a + b) / values.length;
