package lightning.scene;

import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import lightning.scene.light.Light;

/** Part of a picture's light that can be made brighter or darker alone: that of a light, or that of all environments together. */
public sealed interface Contribution {
    Contribution ENVIRONMENT = new OfEnvironment();

    /** @param name name of a light of the scene */
    record OfLight(String name) implements Contribution {}

    /** Light of all environments, with their visible images. */
    record OfEnvironment() implements Contribution {}

    /** Returns the contribution of a light. */
    static Contribution of(Light light) {
        return new OfLight(light.name());
    }

    /** Returns the contributions of all lights that shine, in the scene's order; that of the environment comes last. */
    static List<Contribution> shining(Scene scene) {
        boolean hasEnvironment = scene.rig().isEnvironmentActive() && scene.world().hasEnvironmentLight();
        return Stream.concat(scene.lights().stream().filter(scene::isActive).map(Contribution::of),
                hasEnvironment ? Stream.of(ENVIRONMENT) : Stream.empty()).toList();
    }

    /** Returns a name that no other contribution to the scene has: the light's, or a {@linkplain #environmentName name of the environment}. */
    default String name(Scene scene) {
        return switch (this) {
            case OfLight(String name) -> name;
            case OfEnvironment _ -> environmentName(scene.lights().stream().map(Light::name).toList());
        };
    }

    /** Returns {@code environment}, or if one of these names is the same, {@code environment 2} or a later number. */
    static String environmentName(List<String> others) {
        String name = World.NAME;
        for (int n = 2; others.contains(name); n++) {
            name = World.NAME + " " + n;
        }
        return name;
    }

    /** Returns the contribution of a name, whether it shines or not. If no light has the name {@code environment}, it is the environment's. */
    static Optional<Contribution> named(Scene scene, String name) {
        if (scene.light(name).isPresent()) {
            return Optional.of(new OfLight(name));
        }
        boolean isEnvironment = name.equals(World.NAME) || name.equals(ENVIRONMENT.name(scene));
        return isEnvironment && scene.world().hasEnvironment() ? Optional.of(ENVIRONMENT) : Optional.empty();
    }

    /** Returns the light of a scene; empty for the environment, and for a light that the scene does not have. */
    default Optional<Light> light(Scene scene) {
        return this instanceof OfLight(String name) ? scene.light(name) : Optional.empty();
    }
}
