// The part of the time axis that is seen, and the way between times and pixels.

const SHORTEST_NS = 200;

class View {
  constructor(trace) {
    this.min = trace.start;
    this.max = trace.end;
    this.begin = this.min;
    this.end = this.max;
    this.width = 1;
  }

  get span() {
    return this.end - this.begin;
  }

  /** Nanoseconds of a pixel. */
  get resolution() {
    return this.span / this.width;
  }

  x(time) {
    return ((time - this.begin) / this.span) * this.width;
  }

  time(x) {
    return this.begin + (x / this.width) * this.span;
  }

  /** Show the time between two instants, or as much of it as there is. */
  show(begin, end) {
    const span = clamp(end - begin, Math.min(SHORTEST_NS, this.max - this.min), this.max - this.min);
    this.begin = clamp((begin + end - span) / 2, this.min, this.max - span);
    this.end = this.begin + span;
  }

  zoom(factor, time) {
    const share = (time - this.begin) / this.span;
    const span = clamp(this.span * factor, Math.min(SHORTEST_NS, this.max - this.min), this.max - this.min);
    const begin = clamp(time - share * span, this.min, this.max - span);
    this.begin = begin;
    this.end = begin + span;
  }

  /** Move by a share of what is seen. */
  pan(share) {
    this.panBy(share * this.span);
  }

  panBy(ns) {
    const begin = clamp(this.begin + ns, this.min, this.max - this.span);
    this.end = begin + this.span;
    this.begin = begin;
  }

  /** Bring an instant into sight; the middle if it is not there yet. */
  reveal(time) {
    const edge = this.span * 0.08;
    if (time < this.begin + edge || time > this.end - edge) this.panBy(time - (this.begin + this.end) / 2);
  }
}
