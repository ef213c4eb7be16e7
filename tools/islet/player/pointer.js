// Mouse, pen and fingers on the canvas: dragging pans, the wheel and two fingers zoom, a double click fits the view again.

const wheelLine = 33; // pixels, for wheels that count lines
const zoomPerPixel = 0.0015; // of a wheel's turn

export function listenToPointer(canvas, camera, onChange, onFit) {
    const pointers = new Map(); // those that are down, by id

    const middle = () => {
        const all = [...pointers.values()];
        const x = all.reduce((sum, p) => sum + p.x, 0) / all.length, y = all.reduce((sum, p) => sum + p.y, 0) / all.length;
        return { x, y, spread: all.length > 1 ? Math.hypot(all[0].x - all[1].x, all[0].y - all[1].y) : 0 };
    };

    canvas.addEventListener("pointerdown", (event) => {
        canvas.setPointerCapture(event.pointerId);
        pointers.set(event.pointerId, { x: event.offsetX, y: event.offsetY });
        canvas.classList.add("dragged");
    });
    canvas.addEventListener("pointermove", (event) => {
        if (!pointers.has(event.pointerId)) return;
        const before = middle();
        pointers.set(event.pointerId, { x: event.offsetX, y: event.offsetY });
        const after = middle();
        camera.pan(after.x - before.x, after.y - before.y);
        if (before.spread > 0 && after.spread > 0) camera.zoom(after.spread / before.spread, after.x, after.y);
        onChange();
    });
    for (const end of ["pointerup", "pointercancel"]) {
        canvas.addEventListener(end, (event) => {
            pointers.delete(event.pointerId);
            canvas.classList.toggle("dragged", pointers.size > 0);
        });
    }
    canvas.addEventListener("wheel", (event) => {
        event.preventDefault();
        camera.zoom(Math.exp(-zoomPerPixel * event.deltaY * (event.deltaMode === 0 ? 1 : wheelLine)), event.offsetX, event.offsetY);
        onChange();
    }, { passive: false });
    canvas.addEventListener("dblclick", onFit);
}
