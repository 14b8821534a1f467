package lightning.document;

import lightning.document.manipulation.DragRounding;
import lightning.document.manipulation.PreviewCamera;
import lightning.document.manipulation.ScenePicker;
import lightning.document.manipulation.Snapping;
import lightning.document.manipulation.Viewport;
import lightning.scene.Scene;
import lightning.scene.light.Light;
import lightning.scene.light.LightType;

/** Adds a light that faces a surface point. */
public final class LightAtPoint {
    /** Share of the free distance above the point that a light may use, so that it stays in front of the next surface. */
    private static final double FREE_SHARE = 0.8;

    private LightAtPoint() {}

    /**
     * Adds a light on the point's normal, aimed at the point. Its distance and size are those of {@link LightEdits#add(Scene, LightType)},
     * or smaller if a surface is closer.
     *
     * @param picker finds surfaces of the scene
     * @param canvas size of the displayed picture, which decides how far numbers are rounded
     */
    public static EditOutcome add(Scene scene, LightType type, ScenePicker picker, ScenePicker.SurfaceHit hit, Viewport canvas) {
        return EditOutcome.of(() -> {
            Scene added = LightEdits.add(scene, type).sceneOr(scene);
            Light initial = added.lights().getLast();
            double initialDistance = initial.position().minus(scene.camera().to()).length();
            Light facing =
                    initial.withDirection(hit.normal().negated()).withPosition(hit.point().plus(hit.normal().times(initialDistance)));
            double distance = picker.findOccluder(hit, facing)
                    .map(surface -> Math.min(initialDistance, FREE_SHARE * surface.point().minus(hit.point()).length()))
                    .orElse(initialDistance);
            Light placed = facing.withPosition(hit.point().plus(hit.normal().times(distance)));
            Light rounded = DragRounding.round(initial, placed, PreviewCamera.of(scene), canvas);
            return added.withLight(type.isSurface() ? scaled(rounded, distance / initialDistance) : rounded);
        });
    }

    private static Light scaled(Light light, double factor) {
        return light.withArea(light.area().withWidth(Snapping.snapDistance(factor * light.area().width()))
                .withHeight(Snapping.snapDistance(factor * light.area().height()))
                .withRadius(Snapping.snapDistance(factor * light.area().radius())));
    }
}
