// Mouse, touch and pen on the diagram: zoom, pan, cursors, and what is under the pointer.

const SNAP_PX = 7;

function followPointer(diagram) {
  const { stage, view, tip } = diagram;
  const held = new Map();
  let moved = 0;
  let range = null;

  const place = (event) => {
    const box = stage.getBoundingClientRect();
    return { x: event.clientX - box.left, y: event.clientY - box.top };
  };

  stage.addEventListener(
    "wheel",
    (event) => {
      if (event.altKey) return;
      event.preventDefault();
      const amount = event.deltaY * (event.deltaMode === 1 ? 16 : 1);
      if (event.shiftKey || Math.abs(event.deltaX) > Math.abs(event.deltaY)) {
        view.panBy((event.deltaX || amount) * view.resolution);
      } else view.zoom(Math.exp(clamp(amount, -200, 200) * 0.003), view.time(place(event).x));
      diagram.changed();
      hover(event);
    },
    { passive: false },
  );

  stage.addEventListener("pointerdown", (event) => {
    if (event.button !== 0) return;
    held.set(event.pointerId, place(event));
    stage.setPointerCapture(event.pointerId);
    moved = 0;
    range = event.shiftKey ? view.time(place(event).x) : null;
    tip.hidden = true;
  });

  stage.addEventListener("pointermove", (event) => {
    if (!held.has(event.pointerId)) {
      hover(event);
      return;
    }
    const before = held.get(event.pointerId);
    const now = place(event);
    moved += Math.abs(now.x - before.x) + Math.abs(now.y - before.y);
    if (held.size === 2) pinch(event.pointerId, before, now);
    else if (range === null) view.panBy((before.x - now.x) * view.resolution);
    held.set(event.pointerId, now);
    diagram.changed();
  });

  const release = (event) => {
    if (!held.delete(event.pointerId) || event.type === "pointercancel") return;
    const at = place(event);
    if (range !== null && moved > 6) {
      const other = view.time(at.x);
      view.show(Math.min(range, other), Math.max(range, other));
      diagram.changed();
    } else if (moved <= 6) click(event, at);
    range = null;
  };
  stage.addEventListener("pointerup", release);
  stage.addEventListener("pointercancel", release);
  stage.addEventListener("pointerleave", () => {
    tip.hidden = true;
  });

  stage.addEventListener("dblclick", (event) => {
    const found = under(place(event));
    if (found === null) return;
    const room = (found.end - found.start) * 0.3;
    view.show(found.start - room, found.end + room);
    diagram.changed();
  });

  function pinch(id, before, now) {
    const [other] = [...held].filter(([key]) => key !== id).map(([, where]) => where);
    const wide = Math.max(12, Math.abs(before.x - other.x));
    const wider = Math.max(12, Math.abs(now.x - other.x));
    view.zoom(wide / wider, view.time((before.x + other.x) / 2));
    view.panBy(((before.x - now.x) / 2) * view.resolution);
  }

  function click(event, at) {
    const row = diagram.rowAt(at.y);
    if (row?.track) diagram.select(row.track);
    diagram.setCursor(event.shiftKey || event.ctrlKey || event.metaKey ? "B" : "A", snapped(row, at.x));
  }

  /** The time at a place, or that of the change beside it. */
  function snapped(row, x) {
    const time = view.time(x);
    if (!row?.track) return time;
    const { times } = row.track;
    const index = lastNotAfter(times, time);
    const near = [times[index], times[index + 1]].filter((at) => at !== undefined && Math.abs(view.x(at) - x) <= SNAP_PX);
    near.sort((one, other) => Math.abs(one - time) - Math.abs(other - time));
    return near[0] ?? time;
  }

  /** The value or span under a place, with its times. */
  function under({ x, y }) {
    const row = diagram.rowAt(y);
    if (!row?.track) return null;
    const { track } = row;
    const time = view.time(x);
    if (track.drawn === "spans") {
      const item = track.itemAt(time, y - row.top, view.resolution * 3);
      return item && { start: item.start, end: item.end, parts: () => spanDetails(item, view) };
    }
    const index = track.indexAt(time);
    if (index < 0) return null;
    return {
      start: track.startOf(index),
      end: track.endOf(index),
      parts: () => channelDetails(track, index, time, view, diagram.trace),
    };
  }

  function hover(event) {
    if (event.pointerType === "touch") return;
    const found = under(place(event));
    tip.hidden = found === null;
    if (found === null) return;
    tip.replaceChildren(...found.parts());
    const { width, height } = tip.getBoundingClientRect();
    const right = event.clientX + 18 + width > innerWidth;
    tip.style.left = `${Math.max(4, right ? event.clientX - 18 - width : event.clientX + 18)}px`;
    tip.style.top = `${clamp(event.clientY + 14, 4, Math.max(4, innerHeight - height - 4))}px`;
  }

  // The overview: where one presses is the middle of what is seen.
  const go = (event) => {
    const box = diagram.overview.getBoundingClientRect();
    const time = view.min + ((event.clientX - box.left) / box.width) * (view.max - view.min);
    view.panBy(time - (view.begin + view.end) / 2);
    diagram.changed();
  };
  diagram.overview.addEventListener("pointerdown", (event) => {
    diagram.overview.setPointerCapture(event.pointerId);
    go(event);
  });
  diagram.overview.addEventListener("pointermove", (event) => {
    if (diagram.overview.hasPointerCapture(event.pointerId)) go(event);
  });
}
