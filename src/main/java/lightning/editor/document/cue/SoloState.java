package lightning.editor.document.cue;

import java.util.Set;
import java.util.stream.Collectors;
import lightning.scene.light.Light;

/**
 * Solos of a lighting that have an effect, and what they mute.
 *
 * @param lights      names of the lights that are solo and on, themselves or by their group
 * @param environment true if the environment is solo
 */
record SoloState(Lighting lighting, Set<String> lights, boolean environment) {
    static SoloState of(Lighting lighting) {
        return new SoloState(lighting, lighting.rig().lights().stream().filter(l -> isSolo(lighting.rig().effectiveLight(l)))
                .map(Light::name).collect(Collectors.toUnmodifiableSet()),
                lighting.world().solo() && lighting.world().lightIntensity() > 0);
    }

    private static boolean isSolo(Light effective) {
        return effective.solo() && effective.on();
    }

    /** Returns whether the same lights are solo in both, and the environment in both or in none. */
    boolean hasSameSolos(SoloState o) {
        return lights.equals(o.lights) && environment == o.environment;
    }

    /** Returns whether a light is on, and not muted by a solo. */
    boolean isActive(Light light) {
        return lighting.rig().effectiveLight(light).on() && (lights.contains(light.name()) || lights.isEmpty() && !environment);
    }

    /** Returns whether a light's solo mutes the light of the environment, whose image stays visible. */
    boolean isEnvironmentMuted() {
        return lighting.world().environment().isPresent() && !environment && !lights.isEmpty();
    }
}
