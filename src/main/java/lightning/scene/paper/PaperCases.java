package lightning.scene.paper;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.function.Predicate;
import java.util.function.UnaryOperator;
import java.util.stream.Stream;
import lightning.base.math.Rgb;
import lightning.base.math.Vec3;
import lightning.scene.Scene;
import lightning.scene.light.Light;
import lightning.scene.light.LightType;
import lightning.scene.value.Attenuation;
import lightning.scene.value.SceneLimits;

/**
 * Edits printed in the paper (§4.1–4.9), and more of materials and shapes, for any scene.
 *
 * <p>Each case edits the first enabled light of the required type. Cases without such a light, or without an effect, are skipped. Without a
 * point light, another light with a position is moved. On {@code scenes/bird.jen} the values are printed in the paper (colors, attenuation,
 * ambience). Others follow from the scene's own values and its camera's view.
 */
public final class PaperCases {
    /** Number of values of each case; some scenes allow fewer for some cases. */
    public static final int VALUES = 3;

    private static final Rgb RED = new Rgb(1, 0, 0);
    private static final Attenuation PRINTED_ATTENUATION = new Attenuation(0.1, 1, 0.1);
    private static final Attenuation PRINTED_NEW_ATTENUATION = new Attenuation(0, 1, 1);

    private static final LightType[] TYPES = {LightType.DIRECTIONAL, LightType.POINT, LightType.SPOT};

    private final List<PaperCase> cases = new ArrayList<>();
    private final Scene scene;
    private final CameraFraming framing;
    /** Index of the value, below {@link #VALUES}. */
    private final int value;

    private PaperCases(Scene scene, int value) {
        this.scene = scene;
        this.framing = CameraFraming.of(scene.camera());
        this.value = value;
    }

    /** Returns the cases of a scene with their first values; the paper's come first, in its order. */
    public static List<PaperCase> of(Scene scene) {
        return of(scene, 0);
    }

    /**
     * Returns the cases of a scene with other values: the paper's times are averages of three runs "of the same test with varying values"
     * (§4.1).
     *
     * @param value 0 to {@link #VALUES} − 1; 0 for the printed values
     */
    public static List<PaperCase> of(Scene scene, int value) {
        PaperCases builder = new PaperCases(scene, value);
        builder.addPrinted();
        builder.addUnprinted();
        builder.cases.addAll(MaterialCases.of(scene, value));
        builder.cases.addAll(ShapeCases.of(scene, value));
        return List.copyOf(builder.cases);
    }

    /** Returns the edit that moves a light, with its first value; without a position, the one that rotates a directional light. */
    public static Optional<PaperCase> moveCase(Scene scene) {
        List<PaperCase> cases = of(scene);
        return Stream.of("position", "direction").flatMap(name -> cases.stream().filter(c -> c.name().equals(name))).findFirst();
    }

    private void addPrinted() {
        addEdit("color", "Fig. 6", 98, LightType.DIRECTIONAL, l -> l.withColor(pick(RED, new Rgb(0.3, 0.6, 1), new Rgb(1, 0.8, 0.3))));
        addEdit("intensity", "Fig. 6", 98, LightType.DIRECTIONAL, this::dimmed);
        addEdit("attenuation", "Fig. 8", 98, LightType.POINT, this::attenuated);
        addEdit("angle-smaller", "Fig. 10", 97, LightType.SPOT, l -> l.withAngle(l.angle() * pick(0.6, 0.8, 0.4)));
        addEdit("angle-larger", "Fig. 10", 81, LightType.SPOT,
                l -> l.withAngle(Math.min(l.angle() * pick(1.5, 1.2, 1.8), SceneLimits.MAX_ANGLE)));
        addEdit("dropoff", "Fig. 13", 95, LightType.SPOT, this::steeper);
        addEdit("position", "Fig. 15", 82, firstShining(LightType.POINT).or(() -> firstShining(l -> l.type().hasPosition())),
                l -> l.withPosition(pick(framing.point(0, -0.3, 2.1), framing.point(0.6, 0.3, 1.6), framing.point(-0.7, 0.6, 1.2))));
        addEdit("direction", "Fig. 15", 83, LightType.DIRECTIONAL,
                l -> l.withDirection(pick(framing.vector(1, -1, 0.7), framing.vector(-1, -1, 0.3), framing.vector(0.3, -1, -0.6))));
        addEdit("type", "Fig. 15", 82, pick(LightType.DIRECTIONAL, LightType.DIRECTIONAL, LightType.POINT), this::withOtherType);
        firstShining(TYPES[value]).ifPresent(l -> add("delete", "Fig. 17", 95, removeLight(l)));
        if (scene.lights().size() < SceneLimits.MAX_LIGHTS) {
            add("add", "Fig. 19", 71, addLight(Light.of(freeName(), TYPES[value]).withIntensity(0.3).withPosition(framing.point(-1, 2, 1))
                    .withDirection(framing.vector(0.8, -1, -0.8))));
        }
        add("ambience", "Fig. 21", 98, scene.withWorld(scene.world().withAmbience(
                Math.min(scene.world().ambience() * pick(0.1, 0.5, 2.0), SceneLimits.MAX_AMBIENCE))));
        addEdit("position-feet", "Fig. 23", 82, LightType.POINT,
                l -> l.withPosition(pick(framing.point(0.2, -0.4, 1.2), framing.point(-0.3, -0.35, 1), framing.point(0.4, -0.45, 0.8))));
        addEdit("composite-1", "Fig. 24", 98, LightType.POINT,
                l -> attenuated(dimmed(l)).withColor(pick(new Rgb(0.4, 1, 0.5), new Rgb(1, 0.6, 0.4), new Rgb(0.5, 0.6, 1))));
        addEdit("composite-2", "Fig. 24", 82, LightType.SPOT,
                l -> steeper(dimmed(aimedAt(l, pick(framing.point(0, 0.4, 0), framing.point(0.3, 0.2, 0), framing.point(-0.3, 0, 0.2)))
                        .withAngle(l.angle() * pick(0.7, 0.85, 0.5)))));
    }

    private void addUnprinted() {
        scene.lights().stream().filter(this::isShining).skip(value).findFirst().ifPresent(l -> {
            Scene off = scene.withLight(l.withOn(false));
            add("off", "", Double.NaN, off);
            add("on", "", Double.NaN, off, scene);
            add("solo", "", Double.NaN, scene.withLight(l.withSolo(!l.solo())));
            add("rename", "", Double.NaN, replace(l, l.withName(freeName())));
            add("undo", "", Double.NaN, scene.withLight(dimmed(l)), scene);
        });
        int depth = scene.picture().depth();
        add("depth-less", "", Double.NaN, scene.withPicture(scene.picture().withDepth(Math.max(depth - 1 - value, 0))));
        add("depth-more", "", Double.NaN,
                scene.withPicture(scene.picture().withDepth(Math.min(depth + 1 + value, SceneLimits.MAX_DEPTH))));
        addEdit("spot-turned", "", Double.NaN, LightType.SPOT,
                l -> aimedAt(l, pick(framing.point(0.4, 0, 0.3), framing.point(-0.3, 0.1, 0), framing.point(0, -0.2, 0.5))));
        addEdit("point-to-spot", "", Double.NaN, LightType.POINT,
                l -> aimedAt(l, pick(framing.focus(), framing.point(0.3, 0, 0), framing.point(-0.3, 0.2, 0))).withType(LightType.SPOT));
    }

    @SafeVarargs
    private <T> T pick(T... values) {
        return values[value];
    }

    private Light dimmed(Light light) {
        return light.withIntensity(light.intensity() * pick(0.3, 0.6, 0.1));
    }

    private Light steeper(Light light) {
        return light.withDropoff(Math.min(light.dropoff() * pick(3, 2, 4) + pick(8, 4, 16), SceneLimits.MAX_DROPOFF));
    }

    /**
     * Applies the printed change if the light has the printed value. Otherwise increases the linear and quadratic terms, scaled to the
     * extent of the view.
     */
    private Light attenuated(Light light) {
        Attenuation a = light.attenuation();
        double factor = pick(1.0, 0.5, 2.0);
        return light.withAttenuation(a.equals(PRINTED_ATTENUATION)
                ? new Attenuation(PRINTED_NEW_ATTENUATION.constant(), factor * PRINTED_NEW_ATTENUATION.linear(),
                        factor * PRINTED_NEW_ATTENUATION.quadratic())
                : new Attenuation(a.constant(), clamped(a.linear() + factor * 0.5 / framing.extent()),
                        clamped(a.quadratic() + factor * 0.5 / (framing.extent() * framing.extent()))));
    }

    private static double clamped(double attenuation) {
        return Math.min(attenuation, SceneLimits.MAX_ATTENUATION);
    }

    /** Changes directional to point, directional to spot, or point to directional. */
    private Light withOtherType(Light light) {
        return pick(withPosition(light).withType(LightType.POINT), withPosition(light).withType(LightType.SPOT),
                light.withType(LightType.DIRECTIONAL));
    }

    /** Gives a directional light without a position one on its axis to the focus. */
    private Light withPosition(Light light) {
        return light.withPosition(light.position().equals(Vec3.ZERO)
                ? framing.focus().minus(light.direction().normalized().times(3 * framing.extent())) : light.position());
    }

    /** Turns the light to a point; unchanged if it is at that point. */
    private static Light aimedAt(Light light, Vec3 target) {
        Vec3 direction = target.minus(light.position());
        return direction.equals(Vec3.ZERO) ? light : light.withDirection(direction);
    }

    private void addEdit(String name, String figure, double saving, LightType type, UnaryOperator<Light> edit) {
        addEdit(name, figure, saving, firstShining(type), edit);
    }

    private void addEdit(String name, String figure, double saving, Optional<Light> light, UnaryOperator<Light> edit) {
        light.ifPresent(l -> add(name, figure, saving, scene.withLight(edit.apply(l))));
    }

    private void add(String name, String figure, double saving, Scene... steps) {
        if (!steps[0].equals(scene)) {
            List<Scene> scenes = new ArrayList<>(List.of(scene));
            scenes.addAll(Arrays.asList(steps));
            cases.add(new PaperCase(name, figure, saving, scenes));
        }
    }

    private Optional<Light> firstShining(LightType type) {
        return firstShining(l -> l.type() == type);
    }

    private Optional<Light> firstShining(Predicate<Light> condition) {
        return scene.lights().stream().filter(l -> condition.test(l) && isShining(l)).findFirst();
    }

    private boolean isShining(Light light) {
        return scene.isActive(light) && light.intensity() > 0 && !light.color().isBlack();
    }

    private Scene replace(Light light, Light replacement) {
        return scene.withLights(scene.lights().stream().map(l -> l == light ? replacement : l).toList());
    }

    private Scene removeLight(Light light) {
        return scene.withLights(scene.lights().stream().filter(l -> l != light).toList());
    }

    private Scene addLight(Light light) {
        List<Light> lights = new ArrayList<>(scene.lights());
        lights.add(light);
        return scene.withLights(lights);
    }

    /** Returns a name that no light or node has. */
    private String freeName() {
        String name = "light_new";
        for (int i = 2; scene.isNameUsed(name); i++) {
            name = "light_new_" + i;
        }
        return name;
    }
}
