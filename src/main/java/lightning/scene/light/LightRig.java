package lightning.scene.light;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Predicate;
import java.util.function.UnaryOperator;
import java.util.stream.Stream;
import lightning.base.math.Vec3;
import lightning.base.text.Quote;
import lightning.base.text.RefusalException;
import lightning.scene.node.NodeNames;
import lightning.scene.value.SceneLimits;

/**
 * Lights of a scene, in the order in which their contributions are summed, and their light groups. Immutable; an edit of one light or group
 * shares the table of names.
 */
public final class LightRig {
    /** No lights. */
    public static final LightRig EMPTY = LightRig.of(List.of());
    /** Meters per scene unit if a scene does not say. */
    public static final double METERS = 1;

    private final List<Light> lights;
    private final List<LightGroup> lightGroups;
    private final LightRigNames names;
    /** Directional lights that represent each environment. */
    private final List<EnvironmentLights> environments;
    /** Meters per scene unit. */
    private final double meters;
    /** Surfaces of the shapes that are lights, by the shapes' names. */
    private final Map<String, ObjectSurface> surfaces;
    private final List<Light> effectiveLights;
    /** True if any light is solo and on, so that the others are dark. */
    private final boolean anySolo;

    private LightRig(List<Light> lights, List<LightGroup> lightGroups, LightRigNames names, List<EnvironmentLights> skies, double meters,
            Map<String, ObjectSurface> surfaces) {
        this.lights = withoutSurfaces(lights);
        this.lightGroups = lightGroups;
        this.names = names;
        this.environments = skies;
        this.meters = meters;
        this.surfaces = surfaces;
        List<Light> resolved = this.lights.stream().allMatch(l -> effectiveLight(l) == l) ? this.lights
                : this.lights.stream().map(this::effectiveLight).toList();
        effectiveLights = skies.isEmpty() ? resolved
                : Stream.concat(resolved.stream(), skies.stream().flatMap(sky -> sky.lights().stream())).toList();
        anySolo = effectiveLights.stream().anyMatch(l -> l.solo() && l.on());
    }

    /** Returns lights as documents have them: the surface of an object belongs to the scene. */
    private static List<Light> withoutSurfaces(List<Light> lights) {
        return lights.stream().allMatch(l -> l.area().surface().isEmpty()) ? lights
                : lights.stream().map(l -> l.withArea(l.area().withSurface(Optional.empty()))).toList();
    }

    /** Creates a rig without light groups; see {@link #of(List, List)}. */
    public static LightRig of(List<Light> lights) {
        return of(lights, List.of());
    }

    /**
     * @param lights lights with names unique among lights and groups; the group of each is one of {@code lightGroups}, or none
     * @param lightGroups light groups with unique names
     * @throws RefusalException if a name is taken or a group missing, or if there are more lights or groups than {@link
     *     SceneLimits} allows
     */
    public static LightRig of(List<Light> lights, List<LightGroup> lightGroups) {
        List<Light> lightList = List.copyOf(lights);
        List<LightGroup> groups = List.copyOf(lightGroups);
        SceneLimits.checkRange("the number of lights", lightList.size(), 0, SceneLimits.MAX_LIGHTS);
        SceneLimits.checkRange("the number of light groups", groups.size(), 0, SceneLimits.MAX_LIGHT_GROUPS);
        return new LightRig(lightList, groups, new LightRigNames(lightList, groups), List.of(), METERS, Map.of());
    }

    public List<Light> lights() {
        return lights;
    }

    public List<LightGroup> lightGroups() {
        return lightGroups;
    }

    /**
     * Returns this rig in the light of environments, which come last among the effective lights.
     *
     * @param v    directional lights of each, with names that the rig does not use; empty for none
     * @param unit meters per scene unit
     */
    public LightRig withEnvironments(List<EnvironmentLights> v, double unit) {
        return v.equals(environments) && unit == meters ? this
                : new LightRig(lights, lightGroups, names, v, unit, surfaces);
    }

    /** Returns this rig with the surfaces of the shapes that are lights, by the shapes' names; a light of another shape is dark. */
    public LightRig withSurfaces(Map<String, ObjectSurface> v) {
        return v.equals(surfaces) ? this : new LightRig(lights, lightGroups, names, environments, meters, v);
    }

    /** Returns the surface of a shape that is a light. */
    public Optional<ObjectSurface> surface(String shape) {
        return Optional.ofNullable(surfaces.get(shape));
    }

    /**
     * Returns the lights that are rendered: all lights in the same order as {@link #effectiveLight} returns them, then those of the
     * environment.
     */
    public List<Light> effectiveLights() {
        return effectiveLights;
    }

    /**
     * Returns whether an environment lights the scene.
     *
     * @param index its number among all environments of the world
     */
    public boolean isEnvironmentActive(int index) {
        return isActive(environments.get(index).units().getFirst());
    }

    /** Returns the index among the effective lights of the first light of an environment; their number for the number of environments. */
    public int environmentStart(int index) {
        return lights.size() + environments.stream().limit(index).mapToInt(sky -> sky.units().size()).sum();
    }

    /** Returns the lights of an environment. */
    public EnvironmentLights environment(int index) {
        return environments.get(index);
    }

    /** Returns the number of environments. */
    public int environmentCount() {
        return environments.size();
    }

    /**
     * Returns a light with its group, exposure, unit and temperature multiplied into its color and intensity; the light itself if it has
     * none.
     *
     * @throws RefusalException if its group does not exist
     */
    public Light effectiveLight(Light light) {
        Light resolved = Emission.resolve(light.type() == LightType.OBJECT ? onSurface(light) : light, meters);
        if (light.lightGroup().isEmpty()) {
            return resolved;
        }
        return lightGroup(light.lightGroup()).orElseThrow(() -> new RefusalException(
                "light " + Quote.of(light.name()) + ": there is no light group " + Quote.of(light.lightGroup()))).applyTo(resolved);
    }

    /**
     * Returns the value of the light's face in the picture, divided by color times intensity. For a photometric unit the value is its luminance in
     * nits. An inverse-square light is as bright as white paper that it would light if it touched the paper and filled its view: π/A times color
     * and intensity, where A is the area seen along the axis. Other relative lights have no luminance: their face has color times intensity, as white
     * paper at falloff 1. A texture multiplies it.
     */
    public double radianceFactor(Light light) {
        boolean isPhysical = light.falloff() == Falloff.INVERSE_SQUARE || light.emission().unit() == IntensityUnit.NIT;
        return isPhysical ? Math.min(Math.PI / IntensityUnit.luminousArea(effectiveLight(light)), SceneLimits.MAX_INTENSITY) : 1;
    }

    /** Returns the light of an object with the surface of its shape, if there is one; another light as it is. */
    public Light withSurface(Light light) {
        return light.type() != LightType.OBJECT ? light
                : light.withArea(light.area().withSurface(surface(light.area().shape()).filter(s -> s.area() > 0)));
    }

    /** Returns the light of an object on the surface of its shape; dark if it has none. */
    private Light onSurface(Light light) {
        Light placed = withSurface(light);
        Optional<ObjectSurface> surface = placed.area().surface();
        return surface.isEmpty() ? placed.withIntensity(0) : placed.withPosition(surface.get().middle(Vec3.ZERO));
    }

    /** Returns a light that shines the same where a scene unit is one meter. */
    public Light inMeters(Light light) {
        return meters == METERS ? light : Emission.withUnit(light, IntensityUnit.RELATIVE, meters);
    }

    /**
     * Checks the names of nodes for conflicts with its lights and groups.
     *
     * @throws RefusalException if a shape or a group has the name of a light or a light group
     */
    public void checkDisjoint(NodeNames nodes) {
        names.checkDisjoint(nodes);
    }

    /** Returns the index of the light of that name, or −1. */
    public int indexOf(String name) {
        return names.lightIndex(name);
    }

    /** Returns the light of that name. */
    public Optional<Light> light(String name) {
        int index = indexOf(name);
        return index < 0 ? Optional.empty() : Optional.of(lights.get(index));
    }

    /** Returns the light group of that name. */
    public Optional<LightGroup> lightGroup(String name) {
        int index = names.groupIndex(name);
        return index < 0 ? Optional.empty() : Optional.of(lightGroups.get(index));
    }

    /** Returns whether a light or a light group has the name. */
    public boolean isNameUsed(String name) {
        return indexOf(name) >= 0 || names.groupIndex(name) >= 0;
    }

    /** Returns whether a light contributes: it is on, and solo if any light is, with its group applied. */
    public boolean isActive(Light light) {
        Light effective = effectiveLight(light);
        return effective.on() && (effective.solo() || !anySolo);
    }

    /**
     * Returns this rig with the light of the same name replaced.
     *
     * @throws RefusalException if no light has that name, or if its group is missing
     */
    public LightRig with(Light light) {
        int index = indexOf(light.name());
        if (index < 0) {
            throw new RefusalException("there is no light " + Quote.of(light.name()));
        }
        List<Light> updated = new ArrayList<>(lights);
        updated.set(index, light);
        return new LightRig(List.copyOf(updated), lightGroups, names, environments, meters, surfaces);
    }

    /** Returns this rig with other lights, the same groups and the known surfaces of shapes. */
    public LightRig withLights(List<Light> v) {
        return of(v, lightGroups).withSurfaces(surfaces);
    }

    /**
     * Returns this rig with the light group of the same name replaced.
     *
     * @throws RefusalException if no group has that name
     */
    public LightRig with(LightGroup group) {
        List<LightGroup> updated = new ArrayList<>(lightGroups);
        updated.set(groupIndex(group.name()), group);
        return new LightRig(lights, List.copyOf(updated), names, environments, meters, surfaces);
    }

    /** Returns this rig with one more light group, at the end. */
    public LightRig addLightGroup(LightGroup group) {
        List<LightGroup> updated = new ArrayList<>(lightGroups);
        updated.add(group);
        return of(lights, updated);
    }

    /**
     * Returns this rig with a light group moved.
     *
     * @param before group that follows it afterwards; empty to move it to the end
     * @throws RefusalException if no group has one of these names
     */
    public LightRig moveLightGroup(String group, Optional<String> before) {
        List<LightGroup> updated = new ArrayList<>(lightGroups);
        LightGroup moved = updated.get(groupIndex(group));
        int index = before.map(this::groupIndex).orElse(updated.size());
        updated.add(index, moved);
        updated.remove(groupIndex(group) + (index <= groupIndex(group) ? 1 : 0));
        return of(lights, updated);
    }

    /**
     * Returns this rig with a light group renamed, also in its lights.
     *
     * @throws RefusalException if the group does not exist, or if the new name is taken
     */
    public LightRig renameLightGroup(String group, String newName) {
        List<LightGroup> updated = new ArrayList<>(lightGroups);
        int index = groupIndex(group);
        updated.set(index, updated.get(index).withName(newName));
        return of(reassign(group, newName), updated);
    }

    /**
     * Returns this rig without a light group; its lights stay, without a group.
     *
     * @throws RefusalException if the group does not exist
     */
    public LightRig removeLightGroup(String group) {
        List<LightGroup> updated = new ArrayList<>(lightGroups);
        updated.remove(groupIndex(group));
        return of(reassign(group, ""), updated);
    }

    /**
     * Returns the lights and light groups for another scene: without links and gains of shapes that it does not have.
     *
     * @param exists whether the scene has a shape or group
     */
    public LightRig forShapes(Predicate<String> exists) {
        return of(lights.stream().map(light -> light.retainLinks(exists)).toList(), lightGroups);
    }

    /** Returns this rig with all its lights mapped that have names of shapes: links, gains, or the shape that shines. */
    public LightRig mapLinked(UnaryOperator<Light> change) {
        List<Light> updated = null;
        for (int i = 0; i < lights.size(); i++) {
            Light light = lights.get(i).namesShapes() ? change.apply(lights.get(i)) : lights.get(i);
            if (light != lights.get(i)) {
                updated = updated == null ? new ArrayList<>(lights) : updated;
                updated.set(i, light);
            }
        }
        return updated == null ? this : new LightRig(List.copyOf(updated), lightGroups, names, environments, meters, surfaces);
    }

    private List<Light> reassign(String group, String newGroup) {
        return lights.stream().map(l -> l.lightGroup().equals(group) ? l.withLightGroup(newGroup) : l).toList();
    }

    private int groupIndex(String group) {
        int index = names.groupIndex(group);
        if (index < 0) {
            throw new RefusalException("there is no light group " + Quote.of(group));
        }
        return index;
    }

    @Override
    public boolean equals(Object o) {
        return this == o || o instanceof LightRig r && lights.equals(r.lights) && lightGroups.equals(r.lightGroups)
                && environments.equals(r.environments) && meters == r.meters && surfaces.equals(r.surfaces);
    }

    @Override
    public int hashCode() {
        return 31 * lights.hashCode() + lightGroups.hashCode();
    }
}
