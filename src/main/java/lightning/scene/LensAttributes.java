package lightning.scene;

import java.util.List;
import java.util.Optional;
import lightning.base.text.Messages;
import lightning.scene.attribute.AttributePart;
import lightning.scene.attribute.NumericKind;
import lightning.scene.attribute.SceneAttribute;
import lightning.scene.value.Lens;
import lightning.scene.value.SceneLimits;

/** Attributes of a camera's {@link Lens}. */
public final class LensAttributes {
    private static final AttributePart<Camera, Lens> PART = new AttributePart<>(Lens.PINHOLE, Camera::lens, Camera::withLens,
            camera -> camera.lens().isOpen() ? Optional.empty() : Optional.of(Messages.tr("the aperture is 0")));

    public static final SceneAttribute<Camera, Double> APERTURE = PART.attribute("aperture", "aperture",
            NumericKind.number(0, SceneLimits.MAX_EXTENT, 0.01), "radius, scene units; 0 = pinhole", Lens::aperture, Lens::withAperture)
            .inactiveIf(_ -> Optional.empty());
    public static final SceneAttribute<Camera, Double> FOCUS = PART.attribute("focus", "focus distance",
            NumericKind.number(0, SceneLimits.MAX_COORDINATE, 0.1), "scene units along the view direction; 0 = at the target",
            Lens::focus, Lens::withFocus);
    public static final SceneAttribute<Camera, Integer> BLADES = PART.attribute("blades", "aperture blades",
            NumericKind.integer(0, Lens.MAX_BLADES).withCheck(Lens::checkBlades), "0 = round", Lens::blades, Lens::withBlades);
    public static final SceneAttribute<Camera, Double> ROTATION = PART.attribute("blade_rotation", "rotation of the blades",
            NumericKind.degrees(-SceneLimits.MAX_ROTATION, SceneLimits.MAX_ROTATION, 1), "degrees", Lens::bladeRotation,
            Lens::withBladeRotation);

    /** All attributes, in file order. */
    public static final List<SceneAttribute<Camera, ?>> ALL = List.of(APERTURE, FOCUS, BLADES, ROTATION);

    private LensAttributes() {}
}
