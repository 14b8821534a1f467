package lightning.accuracy;

import java.math.BigDecimal;
import java.math.MathContext;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import lightning.jen.NameText;
import lightning.math.Rgb;
import lightning.math.Vec3;
import lightning.scene.Attenuation;
import lightning.scene.Light;
import lightning.scene.LightMatch;
import lightning.scene.Limits;
import lightning.scene.Material;
import lightning.scene.Scene;
import lightning.scene.TextureMap;

/** Says in the words of the {@code .jen} file what differs between two scenes: lights, materials, ambience and depth. */
final class SceneChange {
    private final List<String> words = new ArrayList<>();

    private SceneChange() {}

    /** What must be set in the one scene to get the other, as in {@code sun.color = 1 0 0, sun.intensity = 0.3}. */
    static String text(Scene before, Scene after) {
        SceneChange change = new SceneChange();
        change.lights(before, after);
        after.materials().forEach(material -> change.material(known(before, material), material));
        change.set("world.ambience", number(before.world().ambience()), number(after.world().ambience()));
        change.set("picture.depth", number(before.picture().depth()), number(after.picture().depth()));
        return String.join(", ", change.words);
    }

    private void lights(Scene before, Scene after) {
        LightMatch match = new LightMatch(before.lights(), after.lights());
        match.gone().forEach(i -> words.add(NameText.of(before.lights().get(i).name()) + " is deleted"));
        for (int i = 0; i < after.lights().size(); i++) {
            Light light = after.lights().get(i);
            if (match.origin(i) < 0) {
                words.add(NameText.of(light.name()) + " is added, " + light.type().name().toLowerCase(Locale.ROOT));
            } else {
                light(before.lights().get(match.origin(i)), light);
            }
        }
    }

    private void light(Light old, Light light) {
        if (!old.name().equals(light.name())) {
            words.add(NameText.of(old.name()) + " is named " + NameText.of(light.name()));
        }
        String name = NameText.of(light.name()) + ".";
        set(name + "type", old.type().name().toLowerCase(Locale.ROOT), light.type().name().toLowerCase(Locale.ROOT));
        set(name + "color", text(old.color()), text(light.color()));
        set(name + "intensity", number(old.intensity()), number(light.intensity()));
        set(name + "at", text(old.position()), text(light.position()));
        set(name + "direction", text(old.direction()), text(light.direction()));
        set(name + "attenuation", text(old.attenuation()), text(light.attenuation()));
        set(name + "angle", number(old.angle()), number(light.angle()));
        set(name + "dropoff", number(old.dropoff()), number(light.dropoff()));
        set(name + "on", old.on() ? "yes" : "no", light.on() ? "yes" : "no");
        set(name + "solo", old.solo() ? "yes" : "no", light.solo() ? "yes" : "no");
    }

    /** The material as it was; one that no line of the file makes is the default. */
    private static Material known(Scene before, Material material) {
        return before.materials().stream().filter(m -> m.name().equals(material.name())).findFirst().orElse(Material.DEFAULT);
    }

    private void material(Material old, Material material) {
        String name = NameText.of(material.name()) + ".";
        set(name + "ambient", text(old.ambient()), text(material.ambient()));
        set(name + "diffuse", text(old.diffuse()), text(material.diffuse()));
        set(name + "specular", text(old.specular()), text(material.specular()));
        set(name + "shininess", number(old.shininess()), number(material.shininess()));
        set(name + "reflective", text(old.reflective()), text(material.reflective()));
        set(name + "texture", texture(old), texture(material));
    }

    private static String texture(Material material) {
        return material.texture().map(TextureMap::file).orElse("none");
    }

    private void set(String what, String before, String after) {
        if (!before.equals(after)) {
            words.add(what + " = " + after);
        }
    }

    private static String text(Rgb c) {
        return number(c.r()) + " " + number(c.g()) + " " + number(c.b());
    }

    private static String text(Vec3 v) {
        return number(v.x()) + " " + number(v.y()) + " " + number(v.z());
    }

    private static String text(Attenuation a) {
        return number(a.constant()) + " " + number(a.linear()) + " " + number(a.quadratic());
    }

    /** Four digits: these words are for reading. */
    private static String number(double value) {
        double rounded = new BigDecimal(value).round(new MathContext(4)).doubleValue();
        return Limits.text(rounded);
    }
}
