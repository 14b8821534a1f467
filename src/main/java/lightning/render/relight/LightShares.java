package lightning.render.relight;

import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CancellationException;
import java.util.stream.IntStream;
import lightning.base.work.Progress;
import lightning.render.cache.PixelCache;
import lightning.render.image.Film;
import lightning.render.relight.tile.RenderOptions;
import lightning.scene.EnvironmentLayer;
import lightning.scene.Scene;
import lightning.scene.light.Light;

/**
 * Shares of the lights in a picture. A light's share is the luminance of its contribution divided by the luminance of the picture, both
 * summed over all pixels, with reflections and indirect light. The share of the environment is what the picture loses without it, its visible
 * background included. This is the only measure of shares: the light mixer and the report of light contributions show it.
 *
 * @param scene       scene of the picture
 * @param lights      share of each light, in the scene's order; {@code double[lights]}
 * @param environments share of each environment, in the scene's order; {@code double[environments]}
 */
public record LightShares(Scene scene, double[] lights, double[] environments) {
    // Immutable by convention: the arrays are written only before construction.

    /**
     * Composes the shares from a cache. Casts no ray, except for finer samples where the environment has an edge.
     *
     * @param cache    cache of a finished picture; not modified
     * @param options  options of its render
     * @param progress counts lights
     * @throws CancellationException if {@code progress} requested cancellation
     */
    public static LightShares of(PixelCache cache, RenderOptions options, Progress progress) {
        Scene scene = cache.scene();
        var all = LightContributions.Region.ofFilm(cache.film());
        double[] shares = new double[scene.lights().size()];
        try (Renderer renderer = new Renderer(options)) {
            for (int l = 0; l < shares.length; l++) {
                progress.report(l, shares.length);
                Light light = scene.lights().get(l);
                if (scene.isActive(light)) {
                    renderer.restore(cache);
                    shares[l] = ofContribution(renderer.lightImage(light.name(), progress.cancellationOnly()), cache.film(), all);
                }
            }
            double[] environments = new double[scene.rig().environmentCount()];
            for (int e = 0; e < environments.length; e++) {
                environments[e] = ofLoss(withoutEnvironment(renderer, cache, e, progress.cancellationOnly()), cache.film(), all);
            }
            return new LightShares(scene, shares, environments);
        }
    }

    /**
     * Returns the shares in an edited scene whose lights differ only in color, intensity, or being on, without a picture of it. The shares of
     * lights that keep their hue are exact, except for values that a picture limits.
     *
     * @return empty if the scenes differ in other ways, or if a light was dark
     */
    public Optional<LightShares> scaledTo(Scene edited) {
        if (!LightValues.areOnlyDifference(scene, edited) || !hasSameActiveEnvironments(edited)) {
            return Optional.empty();
        }
        List<Light> before = scene.rig().effectiveLights();
        List<Light> after = edited.rig().effectiveLights();
        double[] scaled = new double[lights.length];
        double total = 1;
        for (int l = 0; l < scaled.length; l++) {
            double factor = factor(before.get(l), edited, after.get(l));
            if (!Double.isFinite(factor)) {
                return Optional.empty();
            }
            scaled[l] = factor * lights[l];
            total += scaled[l] - lights[l];
        }
        List<EnvironmentLayer> layersBefore = scene.world().environments();
        List<EnvironmentLayer> layersAfter = edited.world().environments();
        double[] scaledEnvironments = new double[environments.length];
        for (int e = 0; e < environments.length; e++) {
            scaledEnvironments[e] =
                    environments[e] == 0 ? 0 : environments[e] * layersAfter.get(e).intensity() / layersBefore.get(e).intensity();
            if (!Double.isFinite(scaledEnvironments[e])) {
                return Optional.empty();
            }
            total += scaledEnvironments[e] - environments[e];
        }
        return Optional.of(new LightShares(edited, normalized(scaled, total), normalized(scaledEnvironments, total)));
    }

    private static double[] normalized(double[] shares, double total) {
        return Arrays.stream(shares).map(share -> total > 0 ? share / total : 0).toArray();
    }

    private boolean hasSameActiveEnvironments(Scene edited) {
        int count = scene.rig().environmentCount();
        return edited.rig().environmentCount() == count && IntStream.range(0, count)
                .allMatch(i -> scene.rig().isEnvironmentActive(i) == edited.rig().isEnvironmentActive(i));
    }

    /** Returns the factor of a light's contribution; infinite if it is unknown. */
    private double factor(Light before, Scene edited, Light after) {
        double afterLuminance = edited.isActive(after) ? after.weight().luminance() : 0;
        double beforeLuminance = scene.isActive(before) ? before.weight().luminance() : 0;
        return afterLuminance == beforeLuminance ? 1 : afterLuminance / beforeLuminance;
    }

    /** Returns the share of a contribution in a region of a picture; 0 if the region is black. */
    static double ofContribution(Film contribution, Film picture, LightContributions.Region region) {
        double whole = region.luminance(picture);
        return whole > 0 ? region.luminance(contribution) / whole : 0;
    }

    /** Returns the share that a region of a picture loses in another picture; 0 if the region is black. */
    static double ofLoss(Film without, Film picture, LightContributions.Region region) {
        double whole = region.luminance(picture);
        return whole > 0 ? (whole - region.luminance(without)) / whole : 0;
    }

    /** Renders the picture without one of its environments; lights that a solo darkens stay dark. */
    static Film withoutEnvironment(Renderer renderer, PixelCache cache, int index, Progress progress) {
        Scene scene = cache.scene();
        renderer.restore(cache);
        renderer.renderWithSameSamples(withActiveLights(scene).withWorld(scene.world().withDarkEnvironment(index)), progress);
        return renderer.film();
    }

    /** Returns the scene whose lights that a solo darkens are off. */
    private static Scene withActiveLights(Scene scene) {
        return scene.withLights(scene.lights().stream().map(l -> scene.isActive(l) ? l : l.withOn(false)).toList());
    }

    /** Returns the summed shares of several lights. */
    public double ofLights(int... indices) {
        double sum = 0;
        for (int index : indices) {
            sum += lights[index];
        }
        return sum;
    }
}
