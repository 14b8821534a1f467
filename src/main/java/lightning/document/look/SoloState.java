package lightning.document.look;

import java.util.HashSet;
import java.util.Set;
import lightning.scene.Contribution;
import lightning.scene.SceneElement;
import lightning.scene.light.Light;

/**
 * Solos of a lighting that have an effect, and what they mute.
 *
 * @param solos lights, with those of solo groups, and environments that are solo and on
 */
record SoloState(Lighting lighting, Set<Contribution> solos) {
    static SoloState of(Lighting lighting) {
        Set<Contribution> solos = new HashSet<>();
        lighting.rig().lights().stream().filter(l -> lighting.rig().effectiveLight(l).solo() && lighting.rig().effectiveLight(l).on())
                .forEach(l -> solos.add(Contribution.of(l)));
        lighting.world().domes().stream().filter(d -> d.solo() && d.lightIntensity() > 0)
                .forEach(d -> solos.add(new SceneElement.OfDome(d.name())));
        return new SoloState(lighting, Set.copyOf(solos));
    }

    /** Returns whether a light is on, and not muted by a solo. */
    boolean isActive(Light light) {
        return lighting.rig().effectiveLight(light).on() && !isMuted(Contribution.of(light));
    }

    /** Returns whether a solo mutes a light or an environment, whose image stays visible. */
    boolean isMuted(Contribution part) {
        return !solos.isEmpty() && !solos.contains(part);
    }
}
