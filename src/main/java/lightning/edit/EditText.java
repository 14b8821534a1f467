package lightning.edit;

import java.math.BigDecimal;
import java.math.MathContext;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import lightning.math.Rgb;
import lightning.math.Vec3;
import lightning.scene.Attenuation;
import lightning.scene.Light;
import lightning.scene.LightMatch;
import lightning.scene.Limits;
import lightning.scene.Material;
import lightning.scene.Sampling;
import lightning.scene.Scene;

/** Says what changed from one scene to another: {@code key: intensity 1 → 1.2}. */
final class EditText {
    private static final MathContext SHORT = new MathContext(4);

    private EditText() {}

    /** One line, never empty. */
    static String of(Scene before, Scene after) {
        List<String> parts = new ArrayList<>();
        lights(new LightMatch(before.lights(), after.lights()), parts);
        change("ambience", number(before.world().ambience()), number(after.world().ambience()), parts);
        change("depth", number(before.picture().depth()), number(after.picture().depth()), parts);
        change("anti-aliasing", sampling(before), sampling(after), parts);
        change("size", size(before), size(after), parts);
        boolean known = materials(before, after, parts);
        boolean other = !known || !before.camera().equals(after.camera()) || !before.nodes().equals(after.nodes())
                || !before.world().background().equals(after.world().background());
        if (other || parts.isEmpty()) {
            parts.add("the scene");
        }
        return String.join(", ", parts);
    }

    /** The edit of one light: {@code key: color, intensity} where several attributes changed. */
    static String of(Light before, Light after) {
        List<String> parts = new ArrayList<>();
        change("name", before.name(), after.name(), parts);
        change("type", lower(before.type()), lower(after.type()), parts);
        change("color", color(before.color()), color(after.color()), parts);
        change("intensity", number(before.intensity()), number(after.intensity()), parts);
        change("position", vector(before.position()), vector(after.position()), parts);
        change("direction", vector(before.direction()), vector(after.direction()), parts);
        change("attenuation", fading(before.attenuation()), fading(after.attenuation()), parts);
        change("angle", number(before.angle()), number(after.angle()), parts);
        change("dropoff", number(before.dropoff()), number(after.dropoff()), parts);
        change("on", before.on() ? "yes" : "no", after.on() ? "yes" : "no", parts);
        change("solo", before.solo() ? "yes" : "no", after.solo() ? "yes" : "no", parts);
        return joined(before.name(), parts);
    }

    private static void lights(LightMatch match, List<String> parts) {
        match.gone().forEach(i -> parts.add("delete " + match.before().get(i).name()));
        boolean ordered = true;
        int last = -1;
        for (int i = 0; i < match.after().size(); i++) {
            Light after = match.after().get(i);
            int origin = match.origin(i);
            if (origin < 0) {
                parts.add("add " + after.name());
            } else if (!match.before().get(origin).equals(after)) {
                parts.add(of(match.before().get(origin), after));
            }
            ordered &= origin < 0 || origin > last;
            last = Math.max(last, origin);
        }
        if (!ordered) {
            parts.add("order of lights");
        }
    }

    /** Adds what changed of each material; false if the change is more than values of theirs. */
    private static boolean materials(Scene before, Scene after, List<String> parts) {
        if (!before.materials().equals(after.materials())) {
            Map<String, Material> known = before.materialsByName();
            for (Material material : after.materials()) {
                Material old = known.get(material.name());
                if (old != null && !old.equals(material)) {
                    parts.add(of(old, material));
                }
            }
        }
        return names(after).equals(names(before)) || addsDefault(before, after);
    }

    private static boolean addsDefault(Scene before, Scene after) {
        List<String> names = new ArrayList<>(names(before));
        names.add(Material.DEFAULT.name());
        return names(after).equals(names);
    }

    private static List<String> names(Scene scene) {
        return scene.materials().stream().map(Material::name).toList();
    }

    /** The edit of one material: {@code gold: diffuse, shininess} where several properties changed. */
    private static String of(Material before, Material after) {
        List<String> parts = new ArrayList<>();
        change("ambient", color(before.ambient()), color(after.ambient()), parts);
        change("diffuse", color(before.diffuse()), color(after.diffuse()), parts);
        change("specular", color(before.specular()), color(after.specular()), parts);
        change("shininess", number(before.shininess()), number(after.shininess()), parts);
        change("reflective", color(before.reflective()), color(after.reflective()), parts);
        change("texture", texture(before), texture(after), parts);
        return joined(before.name(), parts);
    }

    private static String joined(String name, List<String> parts) {
        return name + ": " + (parts.isEmpty() ? "a little" : parts.size() == 1 ? parts.getFirst()
                : String.join(", ", parts.stream().map(p -> p.substring(0, p.indexOf(' '))).toList()));
    }

    private static String texture(Material material) {
        return material.texture().map(t -> t.file() + " " + number(t.repeatU()) + " × " + number(t.repeatV())).orElse("none");
    }

    private static void change(String what, String before, String after, List<String> parts) {
        if (!before.equals(after)) {
            parts.add(what + " " + before + " → " + after);
        }
    }

    /** Four digits, enough to recognise a value. */
    private static String number(double v) {
        return Limits.text(new BigDecimal(v).round(SHORT).doubleValue());
    }

    private static String vector(Vec3 v) {
        return number(v.x()) + " " + number(v.y()) + " " + number(v.z());
    }

    private static String color(Rgb c) {
        return number(c.r()) + " " + number(c.g()) + " " + number(c.b());
    }

    private static String fading(Attenuation a) {
        return number(a.constant()) + " " + number(a.linear()) + " " + number(a.quadratic());
    }

    private static String size(Scene scene) {
        return scene.picture().width() + " × " + scene.picture().height();
    }

    private static String sampling(Scene scene) {
        Sampling sampling = scene.picture().sampling();
        return lower(sampling.antialias()) + " " + sampling.grid() + " × " + sampling.grid();
    }

    private static String lower(Enum<?> constant) {
        return constant.name().toLowerCase(Locale.ROOT);
    }
}
