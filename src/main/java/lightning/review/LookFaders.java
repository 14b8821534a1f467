package lightning.review;

import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import lightning.base.math.Rgb;
import lightning.scene.Contribution;
import lightning.scene.FaderValues;
import lightning.scene.Scene;
import lightning.scene.SceneElement;
import lightning.scene.light.Emission;
import lightning.scene.light.Light;
import lightning.scene.light.LightGroup;
import lightning.scene.light.LightRig;
import tools.jackson.databind.node.ArrayNode;
import tools.jackson.databind.node.JsonNodeFactory;
import tools.jackson.databind.node.ObjectNode;

/** Positions of the faders of a page that show a look. Only a look whose lights differ in nothing but what faders change has them. */
final class LookFaders {
    /** Stops at which a fader is off. */
    static final double OFF = -8;

    private static final double[] ONE = {1, 1, 1};

    private final Scene page;
    private final Scene look;
    private boolean fits = true;

    private LookFaders(Scene page, Scene look) {
        this.page = page;
        this.look = look;
    }

    /**
     * Returns the positions that show a look.
     *
     * @param page scene of the page's picture
     * @param look the same scene with the lights of the look
     */
    static Optional<ObjectNode> of(Scene page, Scene look) {
        Set<Contribution> shining = Set.copyOf(Contribution.shining(look));
        Set<Contribution> shown = Set.copyOf(Contribution.shining(page));
        // The layer of an environment has its background, which stays where another light is solo.
        if (!shown.containsAll(shining)
                || !shining.containsAll(shown.stream().filter(part -> !(part instanceof SceneElement.OfLight)).toList())
                || !neutral(page, shining).equals(neutral(look, shining))) {
            return Optional.empty();
        }
        var faders = new LookFaders(page, look);
        ObjectNode json = faders.json(shining);
        return faders.fits ? Optional.of(json) : Optional.empty();
    }

    /** Returns a scene with the shining lights only, without what faders change. */
    private static Scene neutral(Scene scene, Set<Contribution> shining) {
        List<Light> lights = scene.lights().stream().filter(light -> shining.contains(Contribution.of(light)))
                .map(light -> light.withEmission(Emission.DEFAULT)).toList();
        List<LightGroup> groups = scene.rig().lightGroups().stream()
                .filter(group -> lights.stream().anyMatch(light -> light.lightGroup().equals(group.name())))
                .map(group -> group.withColor(Rgb.WHITE)).toList();
        Scene neutral = LightWeights.neutral(scene.withRig(LightRig.of(lights, groups)));
        // Without light of an environment its background shows, whose brightness is the intensity.
        for (Contribution part : Contribution.environments(scene)) {
            FaderValues own = part.values(scene);
            neutral = shining.contains(part) ? neutral : part.with(neutral, v -> v.withIntensity(own.intensity()).withOn(own.on()));
        }
        return neutral;
    }

    private ObjectNode json(Set<Contribution> shining) {
        ObjectNode json = JsonNodeFactory.instance.objectNode();
        ArrayNode groups = json.putArray("groups");
        for (LightGroup group : page.rig().lightGroups()) {
            LightGroup other = look.rig().lightGroup(group.name()).orElse(group);
            groups.addObject().put("name", group.name()).put("stops", stops(other.intensity(), group.intensity())).put("mute", !other.on())
                    .put("solo", false);
        }
        ArrayNode lights = json.putArray("lights");
        for (Contribution part : Contribution.shining(page)) {
            boolean couldFit = fits;
            double[] ratios = part.light(look).isPresent() || shining.contains(part) ? ratios(part) : ONE;
            double max = Math.max(ratios[0], Math.max(ratios[1], ratios[2]));
            double stops = stops(max, 1);
            if (!shining.contains(part) && !fits) {
                // The fader of a light that is off may stand anywhere.
                fits = couldFit;
                ratios = ONE;
                max = 1;
                stops = 0;
            }
            ObjectNode light =
                    lights.addObject().put("name", part.name(page)).put("mute", isMuted(part, shining)).put("solo", false).put("stops",
                            stops);
            ArrayNode tint = light.putArray("tint");
            for (double ratio : ratios) {
                tint.add(max > 0 ? ratio / max : 1);
            }
        }
        return json;
    }

    /** Returns whether a light itself is off, or dark since others are solo; a group that is off says so itself. */
    private boolean isMuted(Contribution part, Set<Contribution> shining) {
        Optional<Light> light = part.light(look);
        boolean isGroupOff = light.flatMap(l -> look.rig().lightGroup(l.lightGroup())).filter(group -> !group.on()).isPresent();
        return isGroupOff ? !light.orElseThrow().on() : !shining.contains(part);
    }

    /** Returns the factors of red, green and blue of a light without its group's intensity. */
    private double[] ratios(Contribution part) {
        Optional<Light> light = part.light(look);
        if (light.isEmpty()) {
            double ratio = ratio(part.values(look).intensity(), part.values(page).intensity());
            return new double[] {ratio, ratio, ratio};
        }
        Light ofPage = part.light(page).orElseThrow();
        Light to = look.rig().effectiveLight(light.get());
        Light from = page.rig().effectiveLight(ofPage);
        double group = LightWeights.groupIntensity(look, light.get());
        double others = ratio(group, LightWeights.groupIntensity(page, ofPage));
        double share = others > 0 ? ratio(to.intensity(), from.intensity()) / others : 0;
        return new double[] {share * ratio(to.color().r(), from.color().r()), share * ratio(to.color().g(), from.color().g()),
            share * ratio(to.color().b(), from.color().b())};
    }

    private double ratio(double to, double from) {
        OptionalDouble ratio = to == 0 ? OptionalDouble.of(0) : from > 0 ? OptionalDouble.of(to / from) : OptionalDouble.empty();
        fits &= ratio.isPresent() && ratio.getAsDouble() < Double.POSITIVE_INFINITY;
        return ratio.orElse(0);
    }

    private double stops(double to, double from) {
        double ratio = ratio(to, from);
        double stops = Math.log(ratio) / Math.log(2);
        fits &= ratio == 0 || stops > OFF;
        return ratio == 0 ? OFF : stops;
    }
}
