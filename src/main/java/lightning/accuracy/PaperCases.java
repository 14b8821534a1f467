package lightning.accuracy;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.function.UnaryOperator;
import lightning.math.Rgb;
import lightning.math.Vec3;
import lightning.scene.Attenuation;
import lightning.scene.Group;
import lightning.scene.Light;
import lightning.scene.LightType;
import lightning.scene.Limits;
import lightning.scene.Node;
import lightning.scene.Scene;

/**
 * The paper's printed edits (§4.1–4.9) and a few more, of materials too, for any scene.
 *
 * <p>Each case edits the first light of the type it needs that shines; a case that finds no such
 * light, or would change nothing, is left out. On {@code scenes/bird.jen} the values are those that
 * the paper prints (colours, attenuation, ambience); where the paper shows only pictures, and on other
 * scenes, they follow from the scene's own values and from what its camera sees.
 */
public final class PaperCases {
    private static final Rgb RED = new Rgb(1, 0, 0);
    private static final Attenuation PRINTED_BEFORE = new Attenuation(0.1, 1, 0.1);
    private static final Attenuation PRINTED_AFTER = new Attenuation(0, 1, 1);

    private final List<PaperCase> cases = new ArrayList<>();
    private final Scene scene;
    private final Shot shot;

    private PaperCases(Scene scene) {
        this.scene = scene;
        this.shot = Shot.of(scene.camera());
    }

    /** The cases of a scene, the paper's first, in its order. */
    public static List<PaperCase> of(Scene scene) {
        PaperCases builder = new PaperCases(scene);
        builder.printed();
        builder.further();
        builder.cases.addAll(MaterialCases.of(scene));
        return List.copyOf(builder.cases);
    }

    private void printed() {
        edit("color", "Fig. 6", 98, LightType.DIRECTIONAL, l -> l.withColor(RED));
        edit("intensity", "Fig. 6", 98, LightType.DIRECTIONAL, PaperCases::dimmed);
        edit("attenuation", "Fig. 8", 98, LightType.POINT, this::faded);
        edit("angle-smaller", "Fig. 10", 97, LightType.SPOT, l -> l.withAngle(l.angle() * 0.6));
        edit("angle-larger", "Fig. 10", 81, LightType.SPOT, l -> l.withAngle(Math.min(l.angle() * 1.5, Limits.MAX_ANGLE)));
        edit("dropoff", "Fig. 13", 95, LightType.SPOT, PaperCases::steeper);
        edit("position", "Fig. 15", 82, LightType.POINT, l -> l.withPosition(shot.point(0, -0.3, 2.1)));
        edit("direction", "Fig. 15", 83, LightType.DIRECTIONAL, l -> l.withDirection(shot.vector(1, -1, 0.7)));
        edit("type", "Fig. 15", 82, LightType.DIRECTIONAL, this::asPoint);
        shining(LightType.DIRECTIONAL).ifPresent(l -> add("delete", "Fig. 17", 95, without(l)));
        add("add", "Fig. 19", 71, with(new Light(freshName(), LightType.DIRECTIONAL, Rgb.WHITE, 0.3, shot.point(-1, 2, 1),
                shot.vector(0.8, -1, -0.8), Attenuation.NONE, 30, 0, true, false)));
        add("ambience", "Fig. 21", 98, scene.withWorld(scene.world().withAmbience(scene.world().ambience() * 0.1)));
        edit("position-feet", "Fig. 23", 82, LightType.POINT, l -> l.withPosition(shot.point(0.2, -0.4, 1.2)));
        edit("composite-1", "Fig. 24", 98, LightType.POINT, l -> faded(dimmed(l)).withColor(new Rgb(0.4, 1, 0.5)));
        edit("composite-2", "Fig. 24", 82, LightType.SPOT, l -> steeper(dimmed(aimed(l, shot.point(0, 0.4, 0)))
                .withAngle(l.angle() * 0.7)));
    }

    private void further() {
        scene.lights().stream().filter(this::isShining).findFirst().ifPresent(l -> {
            Scene off = scene.withLight(l.withOn(false));
            add("off", "", Double.NaN, off);
            add("on", "", Double.NaN, off, scene);
            add("solo", "", Double.NaN, scene.withLight(l.withSolo(!l.solo())));
            add("rename", "", Double.NaN, replaced(l, l.withName(freshName())));
            add("undo", "", Double.NaN, scene.withLight(dimmed(l)), scene);
        });
        int depth = scene.picture().depth();
        add("depth-less", "", Double.NaN, scene.withPicture(scene.picture().withDepth(Math.max(depth - 1, 0))));
        add("depth-more", "", Double.NaN, scene.withPicture(scene.picture().withDepth(Math.min(depth + 1, Limits.MAX_DEPTH))));
        edit("spot-turned", "", Double.NaN, LightType.SPOT, l -> aimed(l, shot.point(0.4, 0, 0.3)));
        edit("point-to-spot", "", Double.NaN, LightType.POINT, l -> aimed(l, shot.focus()).withType(LightType.SPOT));
    }

    private static Light dimmed(Light light) {
        return light.withIntensity(light.intensity() * 0.3);
    }

    private static Light steeper(Light light) {
        return light.withDropoff(Math.min(light.dropoff() * 3 + 8, Limits.MAX_DROPOFF));
    }

    /** The printed change where the printed value stands; else the light at one reach fades by two further terms. */
    private Light faded(Light light) {
        Attenuation a = light.attenuation();
        return light.withAttenuation(a.equals(PRINTED_BEFORE) ? PRINTED_AFTER
                : new Attenuation(a.constant(), within(a.linear() + 0.5 / shot.reach()),
                        within(a.quadratic() + 0.5 / (shot.reach() * shot.reach()))));
    }

    private static double within(double attenuation) {
        return Math.min(attenuation, Limits.MAX_ATTENUATION);
    }

    /** A directional light that was never given a place gets one on its way to the focus. */
    private Light asPoint(Light light) {
        Vec3 at = light.position().equals(Vec3.ZERO)
                ? shot.focus().minus(light.direction().normalized().times(3 * shot.reach())) : light.position();
        return light.withType(LightType.POINT).withPosition(at);
    }

    /** The light turned towards a point; as it is where it stands in that very point. */
    private static Light aimed(Light light, Vec3 target) {
        Vec3 way = target.minus(light.position());
        return way.equals(Vec3.ZERO) ? light : light.withDirection(way);
    }

    private void edit(String name, String figure, double saving, LightType type, UnaryOperator<Light> edit) {
        shining(type).ifPresent(l -> add(name, figure, saving, scene.withLight(edit.apply(l))));
    }

    private void add(String name, String figure, double saving, Scene... steps) {
        if (!steps[0].equals(scene)) {
            List<Scene> scenes = new ArrayList<>(List.of(scene));
            scenes.addAll(Arrays.asList(steps));
            cases.add(new PaperCase(name, figure, saving, scenes));
        }
    }

    private Optional<Light> shining(LightType type) {
        return scene.lights().stream().filter(l -> l.type() == type && isShining(l)).findFirst();
    }

    private boolean isShining(Light light) {
        return scene.shines(light) && light.intensity() > 0 && !light.color().isBlack();
    }

    private Scene replaced(Light light, Light other) {
        return scene.withLights(scene.lights().stream().map(l -> l == light ? other : l).toList());
    }

    private Scene without(Light light) {
        return scene.withLights(scene.lights().stream().filter(l -> l != light).toList());
    }

    private Scene with(Light light) {
        List<Light> lights = new ArrayList<>(scene.lights());
        lights.add(light);
        return scene.withLights(lights);
    }

    /** A name that neither a light nor a node has. */
    private String freshName() {
        Set<String> taken = new HashSet<>();
        scene.lights().forEach(l -> taken.add(l.name()));
        names(scene.nodes(), taken);
        String name = "light_new";
        for (int i = 2; taken.contains(name); i++) {
            name = "light_new_" + i;
        }
        return name;
    }

    private static void names(List<Node> nodes, Set<String> names) {
        for (Node node : nodes) {
            names.add(node.name());
            if (node instanceof Group group) {
                names(group.children(), names);
            }
        }
    }
}
