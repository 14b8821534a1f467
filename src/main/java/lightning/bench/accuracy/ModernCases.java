package lightning.bench.accuracy;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Predicate;
import java.util.function.UnaryOperator;
import lightning.base.math.Rgb;
import lightning.scene.Scene;
import lightning.scene.light.Light;
import lightning.scene.light.LightType;
import lightning.scene.paper.CameraFraming;
import lightning.scene.paper.MaterialCases;
import lightning.scene.paper.PaperCase;
import lightning.scene.paper.PaperCases;
import lightning.scene.paper.ShapeCases;

/**
 * Kinds of edits of the modern scenes. Unlike {@link PaperCases}, they edit the key light, whatever its type: the light named {@code key},
 * otherwise the first that is on. Cases that a scene does not allow are absent.
 */
public final class ModernCases {
    public static final String INTENSITY = "intensity";
    public static final String POSITION = "position";
    public static final String COLOR = "color";
    public static final String CONE = "cone";
    public static final String MATERIAL_COLOR = "material-color";
    public static final String SHAPE_MOVED = "shape-moved";

    /** Names of all cases in order. */
    public static final List<String> NAMES = List.of(INTENSITY, POSITION, COLOR, CONE, MATERIAL_COLOR, SHAPE_MOVED);

    private static final String KEY = "key";
    private static final Rgb WARM = new Rgb(1, 0.6, 0.3);

    private ModernCases() {}

    /** Returns the cases of a scene, each one edit. */
    public static List<PaperCase> of(Scene scene) {
        List<PaperCase> cases = new ArrayList<>();
        CameraFraming framing = CameraFraming.of(scene.camera());
        Predicate<Light> isOn = light -> scene.isActive(light) && light.intensity() > 0 && !light.color().isBlack();
        Optional<Light> first = scene.lights().stream().filter(isOn).findFirst();
        Optional<Light> key = scene.lights().stream().filter(isOn).filter(light -> light.name().equals(KEY)).findFirst().or(() -> first);
        add(cases, scene, INTENSITY, key, light -> light.withIntensity(light.intensity() * 0.6));
        add(cases, scene, POSITION, key, light -> moved(light, framing));
        add(cases, scene, COLOR, key, light -> light.withColor(light.color().times(WARM)));
        add(cases, scene, CONE, key.filter(ModernCases::hasCone).or(() -> scene.lights().stream().filter(isOn)
                .filter(ModernCases::hasCone).findFirst()), light -> light.withAngle(light.angle() * 0.8));
        MaterialCases.of(scene, 0).stream().filter(edit -> edit.name().equals(MATERIAL_COLOR)).forEach(cases::add);
        ShapeCases.of(scene, 0).stream().filter(edit -> edit.name().equals(SHAPE_MOVED)).forEach(cases::add);
        return List.copyOf(cases);
    }

    private static boolean hasCone(Light light) {
        return light.type() == LightType.SPOT && light.angle() < 180;
    }

    /** Moves a light by a tenth of the view's extent; turns a directional light by about as much. */
    private static Light moved(Light light, CameraFraming framing) {
        return light.type().hasPosition() ? light.withPosition(light.position().plus(framing.right().times(framing.extent() / 10)))
                : light.withDirection(light.direction().normalized().plus(framing.right().times(0.1)));
    }

    private static void add(List<PaperCase> cases, Scene scene, String name, Optional<Light> light, UnaryOperator<Light> edit) {
        light.ifPresent(l -> cases.add(PaperCase.unprinted(name, scene, scene.withLight(edit.apply(l)))));
    }
}
