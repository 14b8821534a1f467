package lightning.editor.document.cue;

import java.util.Set;
import java.util.stream.Collectors;
import lightning.scene.Dome;
import lightning.scene.light.Light;

/**
 * Solos of a lighting that have an effect, and what they mute.
 *
 * @param lights      names of the lights that are solo and on, themselves or by their group
 * @param environment true if the environment of the world is solo
 * @param domes       names of the domes that are solo
 */
record SoloState(Lighting lighting, Set<String> lights, boolean environment, Set<String> domes) {
    static SoloState of(Lighting lighting) {
        return new SoloState(lighting, lighting.rig().lights().stream().filter(l -> isSolo(lighting.rig().effectiveLight(l)))
                .map(Light::name).collect(Collectors.toUnmodifiableSet()),
                lighting.world().solo() && lighting.world().lightIntensity() > 0,
                lighting.world().domes().stream().filter(d -> d.solo() && d.lightIntensity() > 0).map(Dome::name)
                        .collect(Collectors.toUnmodifiableSet()));
    }

    private static boolean isSolo(Light effective) {
        return effective.solo() && effective.on();
    }

    /** Returns whether the same lights and environments are solo in both. */
    boolean hasSameSolos(SoloState o) {
        return lights.equals(o.lights) && environment == o.environment && domes.equals(o.domes);
    }

    /** Returns whether a light is on, and not muted by a solo. */
    boolean isActive(Light light) {
        return lighting.rig().effectiveLight(light).on() && (lights.contains(light.name()) || !isAny());
    }

    /** Returns whether a solo mutes the light of the environment of the world, whose image stays visible. */
    boolean isEnvironmentMuted() {
        return lighting.world().environment().isPresent() && !environment && isAny();
    }

    /** Returns whether a solo mutes the light of a dome, whose image stays visible. */
    boolean isMuted(Dome dome) {
        return isAny() && !domes.contains(dome.name());
    }

    private boolean isAny() {
        return environment || !lights.isEmpty() || !domes.isEmpty();
    }
}
