package lightning.scene;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import lightning.text.Quote;

/**
 * The lights of a scene, in the order in which their contributions are summed. Immutable; an edit of one light shares what
 * is known of the names of all.
 */
public final class Rig {
    /** No light at all. */
    public static final Rig DARK = Rig.of(List.of());

    private final List<Light> lights;
    private final RigNames names;
    /** Whether any light is solo and on, so that the others are dark. */
    private final boolean solo;

    private Rig(List<Light> lights, RigNames names) {
        this.lights = lights;
        this.names = names;
        solo = lights.stream().anyMatch(l -> l.solo() && l.on());
    }

    /**
     * @param lights names unique among themselves
     * @throws IllegalArgumentException if a name is taken or there are more lights than {@link Limits#MAX_LIGHTS}
     */
    public static Rig of(List<Light> lights) {
        List<Light> all = List.copyOf(lights);
        Limits.range("the number of lights", all.size(), 0, Limits.MAX_LIGHTS);
        return new Rig(all, new RigNames(all));
    }

    public List<Light> lights() {
        return lights;
    }

    RigNames names() {
        return names;
    }

    /** The place of the light of that name, or −1. */
    public int place(String name) {
        return names.place(name);
    }

    /** The light of that name. */
    public Optional<Light> light(String name) {
        int place = place(name);
        return place < 0 ? Optional.empty() : Optional.of(lights.get(place));
    }

    /** Whether a light of this rig contributes: it is on, and solo if any light is. */
    public boolean shines(Light light) {
        return light.on() && (light.solo() || !solo);
    }

    /**
     * This rig with the light of the same name replaced.
     *
     * @throws IllegalArgumentException if no light has that name
     */
    public Rig with(Light light) {
        int place = place(light.name());
        if (place < 0) {
            throw new IllegalArgumentException("there is no light " + Quote.of(light.name()));
        }
        List<Light> all = new ArrayList<>(lights);
        all.set(place, light);
        return new Rig(List.copyOf(all), names);
    }

    @Override
    public boolean equals(Object o) {
        return this == o || o instanceof Rig r && lights.equals(r.lights);
    }

    @Override
    public int hashCode() {
        return lights.hashCode();
    }
}
