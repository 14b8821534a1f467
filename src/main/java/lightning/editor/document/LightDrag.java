package lightning.editor.document;

import lightning.scene.Light;

/** What a drag of a light's gizmo does with the light. */
public enum LightDrag {
    ROTATE, ORBIT, DOLLY, TRANSLATE;

    /**
     * The light of the drag's begin, after the whole way of the drag so far.
     *
     * @param right pixels; likewise {@code up}
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
