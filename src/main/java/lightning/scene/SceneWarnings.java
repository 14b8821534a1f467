package lightning.scene;

import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import lightning.base.text.Messages;
import lightning.scene.light.Light;
import lightning.scene.light.LightType;
import lightning.scene.material.Material;
import lightning.scene.node.Shape;

/** Warnings about scenes that are valid, but probably not as intended. */
public final class SceneWarnings {
    private SceneWarnings() {}

    /** Returns the warnings about a scene, clauses without a period; empty for most scenes. */
    public static List<String> of(Scene scene) {
        Stream<String> ambience = countsAmbienceTwice(scene)
                ? Stream.of(Messages.tr("ambience and indirect light count twice: set ambience to 0")) : Stream.empty();
        Stream<String> bulbs =
                scene.materials().stream().filter(m -> !m.bulb().light().isEmpty() && scene.light(m.bulb().light()).isEmpty())
                        .map(m -> Messages.tr("material {0} is the bulb of a light that does not exist: {1}", m.name(), m.bulb().light()));
        Stream<String> lens = scene.camera().lens().isOpen() && !scene.hasDepthOfField()
                ? Stream.of(Messages.tr("the aperture of the camera has no effect: anti-aliasing is off")) : Stream.empty();
        return Stream.of(ambience, bulbs, lens, scene.lights().stream().filter(light -> light.type() == LightType.OBJECT)
                .flatMap(light -> ofObjectLight(scene, light).stream())).flatMap(warnings -> warnings).toList();
    }

    private static Optional<String> ofObjectLight(Scene scene, Light light) {
        if (!(scene.stage().node(light.area().shape()).orElse(null) instanceof Shape shape)) {
            return Optional.of(Messages.tr("light {0} is dark: it has no object that shines", light.name()));
        }
        Material material = scene.materialsByName().getOrDefault(shape.material(), Material.DEFAULT);
        return scene.picture().indirect().isPresent() && shape.visible() && !material.glow().isBlack()
                ? Optional.of(Messages.tr(
                        "object {0} glows and is the light {1}, so indirect light counts it twice: set the glow of {2} to black",
                        shape.name(), light.name(), material.name()))
                : Optional.empty();
    }

    /** Ambience stands for the light that surfaces pass on, which indirect light computes. It acts only on ambient colors. */
    private static boolean countsAmbienceTwice(Scene scene) {
        return scene.picture().indirect().isPresent() && scene.world().ambience() > 0
                && scene.placedShapes().stream().anyMatch(shape -> !shape.material().ambient().isBlack());
    }
}
