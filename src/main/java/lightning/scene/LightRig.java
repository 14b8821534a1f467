package lightning.scene;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.UnaryOperator;
import java.util.stream.Stream;
import lightning.base.text.Quote;

/**
 * The lights of a scene, in the order in which their contributions are summed, and the banks that master some of them. Immutable;
 * an edit of one light or bank shares what is known of the names of all.
 */
public final class LightRig {
    /** No light at all. */
    public static final LightRig EMPTY = LightRig.of(List.of());

    private final List<Light> lights;
    private final List<LightGroup> lightGroups;
    private final LightRigNames names;
    /** The directional lights that an environment is made of. */
    private final List<Light> environmentLights;
    private final List<Light> effectiveLights;
    /** Whether any light is solo and on, so that the others are dark. */
    private final boolean anySolo;

    private LightRig(List<Light> lights, List<LightGroup> banks, LightRigNames names, List<Light> sky) {
        this.lights = lights;
        this.lightGroups = banks;
        this.names = names;
        this.environmentLights = sky;
        List<Light> grouped =
                lights.stream().allMatch(l -> l.lightGroup().isEmpty()) ? lights : lights.stream().map(this::effectiveLight).toList();
        effectiveLights = sky.isEmpty() ? grouped : Stream.concat(grouped.stream(), sky.stream()).toList();
        anySolo = effectiveLights.stream().anyMatch(l -> l.solo() && l.on());
    }

    /** Lights without banks; see {@link #of(List, List)}. */
    public static LightRig of(List<Light> lights) {
        return of(lights, List.of());
    }

    /**
     * @param lights names unique among themselves and the banks'; the bank of each is one of the banks, or none
     * @param banks  names unique too
     * @throws IllegalArgumentException if a name is taken or a bank missing, or if there are more lights or banks than
     *                                  {@link SceneLimits} allows
     */
    public static LightRig of(List<Light> lights, List<LightGroup> banks) {
        List<Light> lightList = List.copyOf(lights);
        List<LightGroup> groups = List.copyOf(banks);
        SceneLimits.checkRange("the number of lights", lightList.size(), 0, SceneLimits.MAX_LIGHTS);
        SceneLimits.checkRange("the number of banks", groups.size(), 0, SceneLimits.MAX_LIGHT_GROUPS);
        return new LightRig(lightList, groups, new LightRigNames(lightList, groups), List.of());
    }

    public List<Light> lights() {
        return lights;
    }

    public List<LightGroup> lightGroups() {
        return lightGroups;
    }

    /** This rig in a world, whose environment's lights come last among those that act. */
    LightRig withEnvironment(World world) {
        if (world.environment().isEmpty() && environmentLights.isEmpty()) {
            return this;
        }
        List<Light> environment = world.environmentLights(this::isNameUsed);
        return environment.equals(environmentLights) ? this : new LightRig(lights, lightGroups, names, environment);
    }

    /**
     * The lights as their banks make them, each in none, in the same order, and behind them those of the environment: those that a picture is
     * made of.
     */
    public List<Light> effectiveLights() {
        return effectiveLights;
    }

    /**
     * A light as its bank makes it: itself where it is in none.
     *
     * @throws IllegalArgumentException if it is in a bank that is not here
     */
    public Light effectiveLight(Light light) {
        if (light.lightGroup().isEmpty()) {
            return light;
        }
        return lightGroup(light.lightGroup()).orElseThrow(() -> new IllegalArgumentException(
                "light " + Quote.of(light.name()) + ": there is no bank " + Quote.of(light.lightGroup()))).applyTo(light);
    }

    LightRigNames names() {
        return names;
    }

    /** The place of the light of that name, or −1. */
    public int indexOf(String name) {
        return names.lightIndex(name);
    }

    /** The light of that name. */
    public Optional<Light> light(String name) {
        int index = indexOf(name);
        return index < 0 ? Optional.empty() : Optional.of(lights.get(index));
    }

    /** The bank of that name. */
    public Optional<LightGroup> lightGroup(String name) {
        int index = names.groupIndex(name);
        return index < 0 ? Optional.empty() : Optional.of(lightGroups.get(index));
    }

    /** Whether a light or a bank has the name. */
    public boolean isNameUsed(String name) {
        return indexOf(name) >= 0 || names.groupIndex(name) >= 0;
    }

    /** Whether a light of this rig contributes: it is on, and solo if any light is; what its bank says counts. */
    public boolean isActive(Light light) {
        Light effective = effectiveLight(light);
        return effective.on() && (effective.solo() || !anySolo);
    }

    /**
     * This rig with the light of the same name replaced.
     *
     * @throws IllegalArgumentException if no light has that name, or if its bank is missing
     */
    public LightRig with(Light light) {
        int index = indexOf(light.name());
        if (index < 0) {
            throw new IllegalArgumentException("there is no light " + Quote.of(light.name()));
        }
        List<Light> updated = new ArrayList<>(lights);
        updated.set(index, light);
        return new LightRig(List.copyOf(updated), lightGroups, names, environmentLights);
    }

    /** This rig with other lights and the same banks. */
    public LightRig withLights(List<Light> v) {
        return of(v, lightGroups);
    }

    /**
     * This rig with the bank of the same name replaced.
     *
     * @throws IllegalArgumentException if no bank has that name
     */
    public LightRig with(LightGroup bank) {
        List<LightGroup> updated = new ArrayList<>(lightGroups);
        updated.set(groupIndex(bank.name()), bank);
        return new LightRig(lights, List.copyOf(updated), names, environmentLights);
    }

    /** This rig with one bank more, the last. */
    public LightRig addLightGroup(LightGroup bank) {
        List<LightGroup> updated = new ArrayList<>(lightGroups);
        updated.add(bank);
        return of(lights, updated);
    }

    /**
     * This rig with a bank at another place among the banks.
     *
     * @param before the bank that it stands before then; empty for the last place
     * @throws IllegalArgumentException if no bank has one of these names
     */
    public LightRig moveLightGroup(String bank, Optional<String> before) {
        List<LightGroup> updated = new ArrayList<>(lightGroups);
        LightGroup moved = updated.get(groupIndex(bank));
        int index = before.map(this::groupIndex).orElse(updated.size());
        updated.add(index, moved);
        updated.remove(groupIndex(bank) + (index <= groupIndex(bank) ? 1 : 0));
        return of(lights, updated);
    }

    /**
     * This rig with a bank of another name; its lights follow.
     *
     * @throws IllegalArgumentException if there is no such bank, or if the new name is taken
     */
    public LightRig renameLightGroup(String bank, String newName) {
        List<LightGroup> updated = new ArrayList<>(lightGroups);
        int index = groupIndex(bank);
        updated.set(index, updated.get(index).withName(newName));
        return of(reassign(bank, newName), updated);
    }

    /**
     * This rig without a bank; its lights stay, in none.
     *
     * @throws IllegalArgumentException if there is no such bank
     */
    public LightRig removeLightGroup(String bank) {
        List<LightGroup> updated = new ArrayList<>(lightGroups);
        updated.remove(groupIndex(bank));
        return of(reassign(bank, ""), updated);
    }

    /** This rig with other links of all its lights. */
    LightRig mapLinks(UnaryOperator<ShapeLinks> links) {
        List<Light> updated = null;
        for (int i = 0; i < lights.size(); i++) {
            Light light = lights.get(i).isLinked() ? lights.get(i).mapLinks(links) : lights.get(i);
            if (light != lights.get(i)) {
                updated = updated == null ? new ArrayList<>(lights) : updated;
                updated.set(i, light);
            }
        }
        return updated == null ? this : new LightRig(List.copyOf(updated), lightGroups, names, environmentLights);
    }

    private List<Light> reassign(String bank, String newGroup) {
        return lights.stream().map(l -> l.lightGroup().equals(bank) ? l.withLightGroup(newGroup) : l).toList();
    }

    private int groupIndex(String bank) {
        int index = names.groupIndex(bank);
        if (index < 0) {
            throw new IllegalArgumentException("there is no bank " + Quote.of(bank));
        }
        return index;
    }

    @Override
    public boolean equals(Object o) {
        return this == o || o instanceof LightRig r && lights.equals(r.lights) && lightGroups.equals(r.lightGroups)
                && environmentLights.equals(r.environmentLights);
    }

    @Override
    public int hashCode() {
        return 31 * lights.hashCode() + lightGroups.hashCode();
    }
}
