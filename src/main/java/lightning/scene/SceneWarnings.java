package lightning.scene;

import java.util.List;
import java.util.stream.Stream;
import lightning.base.text.Messages;

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
        return Stream.concat(ambience, bulbs).toList();
    }

    /** Ambience stands for the light that surfaces pass on, which indirect light computes. It acts only on ambient colors. */
    private static boolean countsAmbienceTwice(Scene scene) {
        return scene.picture().indirect().isPresent() && scene.world().ambience() > 0
                && scene.placedShapes().stream().anyMatch(shape -> !shape.material().ambient().isBlack());
    }
}
