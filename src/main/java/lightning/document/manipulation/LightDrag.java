package lightning.document.manipulation;

import lightning.scene.light.Light;

/** Action of a drag on a light's handle. */
public enum LightDrag {
    ROTATE, ORBIT, DOLLY, TRANSLATE;

    /**
     * Applies the total movement of the drag so far to the light at its start.
     *
     * @param right pixels
     * @param up    pixels
     */
    public Light apply(Light start, PreviewCamera view, Viewport canvas, double right, double up) {
        return switch (this) {
            case ROTATE -> LightManipulation.rotate(start, view, canvas, right, up);
            case ORBIT -> LightManipulation.orbit(start, view, canvas, right, up);
            case DOLLY -> LightManipulation.dolly(start, view, canvas, up);
            case TRANSLATE -> LightManipulation.translate(start, view, canvas, right, up);
        };
    }
}
