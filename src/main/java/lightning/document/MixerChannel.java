package lightning.document;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.UnaryOperator;
import lightning.base.math.Rgb;
import lightning.scene.Contribution;
import lightning.scene.FaderValues;
import lightning.scene.Scene;
import lightning.scene.SceneElement;
import lightning.scene.light.LightAttribute;
import lightning.scene.light.LightGroup;
import lightning.scene.light.LightRig;
import lightning.scene.value.SceneLimits;

/** Channel of the light mixer: a light, an environment, or a light group. */
public sealed interface MixerChannel {
    MixerChannel ENVIRONMENT = new OfContribution(Contribution.ENVIRONMENT);

    /** @param contribution light or environment of the scene */
    record OfContribution(Contribution contribution) implements MixerChannel {}

    /** @param name name of a light group of the scene */
    record OfLightGroup(String name) implements MixerChannel {}

    /** Returns the channel of a light. */
    static MixerChannel ofLight(String name) {
        return new OfContribution(new SceneElement.OfLight(name));
    }

    /**
     * Returns all channels in the order of the scene: lights without a group, then each group followed by its lights, then the environment
     * and the domes.
     */
    static List<MixerChannel> channelsOf(Scene scene) {
        LightRig rig = scene.rig();
        List<MixerChannel> all = new ArrayList<>(members(rig, ""));
        for (LightGroup group : rig.lightGroups()) {
            all.add(new OfLightGroup(group.name()));
            all.addAll(members(rig, group.name()));
        }
        scene.world().domes().stream().map(dome -> new SceneElement.OfDome(dome.name())).filter(dome -> dome.isIn(scene))
                .forEach(dome -> all.add(new OfContribution(dome)));
        return all;
    }

    private static List<MixerChannel> members(LightRig rig, String group) {
        return rig.lights().stream().filter(l -> l.lightGroup().equals(group)).map(l -> ofLight(l.name())).toList();
    }

    /** Returns the name of its light; empty for other channels. */
    default Optional<String> lightName() {
        return this instanceof OfContribution(SceneElement.OfLight(String name)) ? Optional.of(name) : Optional.empty();
    }

    /** Returns the title for people, which no other channel of the scene has. */
    default String title(Scene scene) {
        return switch (this) {
            case OfContribution(Contribution contribution) -> contribution.title(scene);
            case OfLightGroup(String name) -> name;
        };
    }

    /** Returns whether the scene has this channel. */
    default boolean isIn(Scene scene) {
        return switch (this) {
            case OfContribution(Contribution contribution) -> contribution.isIn(scene);
            case OfLightGroup(String name) -> scene.rig().lightGroup(name).isPresent();
        };
    }

    /**
     * Returns the fader's values, of a group those of its master.
     *
     * @throws IllegalArgumentException if the scene does not have the channel
     */
    default FaderValues values(Scene scene) {
        if (this instanceof OfContribution(Contribution contribution)) {
            return contribution.values(scene);
        }
        LightGroup group = lightGroup(scene);
        return new FaderValues(group.intensity(), Optional.of(group.color()), group.on(), group.solo());
    }

    /** Returns the maximum intensity. */
    default double maxIntensity() {
        return this instanceof OfContribution(Contribution contribution) ? contribution.maxIntensity() : SceneLimits.MAX_GROUP_INTENSITY;
    }

    /** Returns the scene with other values, as {@link Contribution#with}. */
    default Scene with(Scene scene, UnaryOperator<FaderValues> change) {
        if (this instanceof OfContribution(Contribution contribution)) {
            return contribution.with(scene, change);
        }
        LightGroup group = lightGroup(scene);
        FaderValues v = change.apply(values(scene));
        return scene.withRig(scene.rig().with(group.withIntensity(v.intensity()).withColor(v.color().orElse(group.color())).withOn(v.on())
                .withSolo(v.solo())));
    }

    private LightGroup lightGroup(Scene scene) {
        return LightGroupEdits.lightGroup(scene, ((OfLightGroup) this).name());
    }

    /** Returns whether the channel can be moved to another place of the mixer. */
    default boolean canBeMoved() {
        return lightName().isPresent() || this instanceof OfLightGroup;
    }

    /** Returns a light's color temperature in kelvin; empty for other channels. */
    default Optional<Double> temperature(Scene scene) {
        return lightName().map(name -> LightEdits.light(scene, name).emission().temperature());
    }

    /** Returns the color that stands for the channel: of a light with the hue of its temperature; empty for environments. */
    default Optional<Rgb> shownColor(Scene scene) {
        return lightName().map(name -> LightEdits.light(scene, name)).map(light -> light.emission().tinted(light.color()))
                .or(() -> values(scene).color());
    }

    /** Returns the scene with another color temperature of a light; unchanged for other channels. Throws as {@link #with}. */
    default Scene withTemperature(Scene scene, double kelvin) {
        return lightName().map(name -> scene.withLight(LightAttribute.TEMPERATURE.with(LightEdits.light(scene, name), kelvin)))
                .orElse(scene);
    }

    /** Returns whether the channel contributes to the image: it is on and not muted by another's solo. */
    default boolean isShining(Scene scene) {
        return switch (this) {
            case OfContribution(Contribution contribution) -> contribution.isShining(scene);
            case OfLightGroup(String name) -> scene.lights().stream().anyMatch(l -> l.lightGroup().equals(name) && scene.isActive(l));
        };
    }

    /** Returns its contributions: itself, or the lights of a group. */
    default List<Contribution> contributions(Scene scene) {
        return switch (this) {
            case OfContribution(Contribution contribution) -> List.of(contribution);
            case OfLightGroup(String name) ->
                    scene.lights().stream().filter(light -> light.lightGroup().equals(name)).map(Contribution::of).toList();
        };
    }
}
