package lightning.render.shading;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.BitSet;
import java.util.Collection;
import java.util.List;
import lightning.scene.Contribution;
import lightning.scene.Dome;
import lightning.scene.Scene;
import lightning.scene.SceneElement;
import lightning.scene.light.Light;

/**
 * The films that add up to the picture of a scene, in the order of their sum: of each light, of each environment its light and its image, of
 * ambient light, and of the rest.
 *
 * @param lights all lights that are rendered, with the weights that films contain; those of dark films are dark. Callers must not modify it
 */
public record FilmParts(Scene scene, List<Dome> environments, FilmPart[] parts, WeightedLight[] lights) {
    /** Returns the films of a scene, each with the light of its contribution at weight 1. */
    public static FilmParts of(Scene scene) {
        return of(scene, false);
    }

    /** Returns the films of a scene. @param isWeighted whether they contain their weights, as the method of 1998 stores its layers */
    public static FilmParts of(Scene scene, boolean isWeighted) {
        List<FilmPart> parts = new ArrayList<>();
        List<Light> effective = scene.rig().effectiveLights();
        WeightedLight[] lights = new WeightedLight[effective.size()];
        for (int l = 0; l < scene.lights().size(); l++) {
            Light light = effective.get(l);
            LightWeight weight = scene.isActive(light) ? LightWeight.of(light.limitedWeight()) : LightWeight.ZERO;
            parts.add(part(FilmPart.Kind.LIGHT, l, weight, isWeighted, l, l + 1));
            WeightedLight its = isWeighted ? WeightedLight.of(scene.lights().get(l), scene) : WeightedLight.ofUnit(light, light, scene);
            // A gain of the film may be above 0 where its product with the light's weight is not.
            boolean isLit = !LightWeight.of(light.diffuseWeight()).isZero() || !LightWeight.of(light.specularWeight()).isZero();
            lights[l] = weight.isZero() ? its.darkened() : isLit ? its : its.withoutSurfaces();
        }
        List<Dome> environments = scene.rig().environmentCount() == 0 ? List.of() : scene.world().environments();
        for (int e = 0; e < environments.size(); e++) {
            int from = scene.rig().environmentStart(e);
            int to = scene.rig().environmentStart(e + 1);
            Dome layer = environments.get(e);
            LightWeight weight =
                    scene.rig().isEnvironmentActive(e) ? LightWeight.gray((float) layer.lightIntensity()) : LightWeight.ZERO;
            parts.add(part(FilmPart.Kind.ENVIRONMENT_LIGHT, e, weight, isWeighted, from, to));
            parts.add(part(FilmPart.Kind.ENVIRONMENT_IMAGE, e, LightWeight.gray(layer.on() ? (float) layer.intensity() : 0), isWeighted, to,
                    to));
            List<Light> units = scene.rig().environment(e).units();
            for (int l = from; l < to; l++) {
                lights[l] = isWeighted ? WeightedLight.of(effective.get(l), scene)
                        : WeightedLight.ofUnit(effective.get(l), units.get(l - from), scene);
                lights[l] = weight.isZero() ? lights[l].darkened() : lights[l];
            }
        }
        parts.add(part(FilmPart.Kind.AMBIENCE, 0, LightWeight.gray((float) scene.world().ambience()), isWeighted, 0, 0));
        parts.add(part(FilmPart.Kind.REST, 0, LightWeight.ONE, isWeighted, 0, 0));
        return new FilmParts(scene, environments, parts.toArray(FilmPart[]::new), lights);
    }

    private static FilmPart part(FilmPart.Kind kind, int index, LightWeight weight, boolean isWeighted, int from, int to) {
        return isWeighted && !weight.isZero() ? new FilmPart(kind, index, LightWeight.ONE, weight, from, to)
                : new FilmPart(kind, index, weight, LightWeight.ONE, from, to);
    }

    /** Returns an environment. */
    public Dome environment(int index) {
        return environments.get(index);
    }

    /** Returns whether rays that hit nothing show an environment, even a dark one, and not the color of the background. */
    public boolean showsEnvironment() {
        return environments.stream().anyMatch(Dome::on);
    }

    /** Returns the number of films. */
    public int count() {
        return parts.length;
    }

    public FilmPart get(int part) {
        return parts[part];
    }

    /** Returns the numbers of all films that are not dark. */
    public BitSet shining() {
        BitSet shining = new BitSet();
        for (int part = 0; part < parts.length; part++) {
            shining.set(part, !parts[part].isDark());
        }
        return shining;
    }

    /** Returns the films of a contribution; none if the scene does not have it. */
    public BitSet of(Contribution contribution) {
        int environment = contribution.environmentIndex(scene);
        int light = contribution instanceof SceneElement.OfLight(String name) ? scene.rig().indexOf(name) : -1;
        BitSet films = new BitSet();
        for (int part = 0; part < parts.length; part++) {
            films.set(part, switch (parts[part].kind()) {
                case LIGHT -> parts[part].index() == light;
                case ENVIRONMENT_LIGHT, ENVIRONMENT_IMAGE -> parts[part].index() == environment;
                case AMBIENCE -> contribution instanceof Contribution.OfAmbience;
                case REST -> contribution instanceof Contribution.OfRest;
            });
        }
        return films;
    }

    /** Returns the films of several contributions. */
    public BitSet of(Collection<? extends Contribution> contributions) {
        BitSet films = new BitSet();
        contributions.forEach(contribution -> films.or(of(contribution)));
        return films;
    }

    /** Returns the weight of each film. */
    public LightWeight[] weights() {
        return Arrays.stream(parts).map(FilmPart::weight).toArray(LightWeight[]::new);
    }

    /**
     * Returns the weight of each film as edge detection sees it: rounded to the nearest power of two (in its logarithm). So most edits of a
     * weight change no edge.
     */
    public LightWeight[] edgeWeights() {
        return Arrays.stream(parts).map(part -> part.weight().toPowersOfTwo()).toArray(LightWeight[]::new);
    }

    /** Returns the gathered light of rays that leave the scene in a film. */
    public BackgroundLight background(int part) {
        FilmPart its = parts[part];
        return switch (its.kind()) {
            case REST -> BackgroundLight.ofColor(scene);
            case ENVIRONMENT_LIGHT -> its.isDark() ? BackgroundLight.NONE
                    : BackgroundLight.of(environments.get(its.index()), its.inside().red());
            case LIGHT, ENVIRONMENT_IMAGE, AMBIENCE -> BackgroundLight.NONE;
        };
    }
}
