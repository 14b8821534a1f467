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
    public Light applied(Light begin, PreviewCamera view, Viewport canvas, double right, double up) {
        return switch (this) {
            case ROTATE -> LightManipulation.rotate(begin, view, canvas, right, up);
            case ORBIT -> LightManipulation.orbit(begin, view, canvas, right, up);
            case DOLLY -> LightManipulation.dolly(begin, view, canvas, up);
            case TRANSLATE -> LightManipulation.translate(begin, view, canvas, right, up);
        };
    }
}
