package lightning.render.match;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CancellationException;
import lightning.base.work.Progress;
import lightning.render.RenderOptions;
import lightning.render.relight.Renderer;
import lightning.scene.Contribution;
import lightning.scene.SamplingSettings;
import lightning.scene.Scene;

/**
 * Searches for places, directions, cones and temperatures of lights, and the rotation of the environment, with which a picture comes closest
 * to a reference. Each step renders the scene at a small size once per number that may change, by exact updates, and solves a
 * {@link LinearMatch} for the intensities and for steps of all numbers together: a Gauss-Newton method in a region of trust, with
 * differences for derivatives. Coarse cells come first, in which shadows and edges of cones overlap with those of the reference.
 */
final class LightSearch implements AutoCloseable {
    /** Pixels of a search: enough for shadows, and rendered in a fraction of a second. */
    private static final int PIXELS = 320 * 180;
    /** Pixels side by side in a cell, from level to level. */
    private static final int[] CELLS = {16, 6, 3};
    /** Largest number of steps of a level. */
    private static final int STEPS = 16;
    /** Size of the first step of each level, in scales of the parameters. */
    private static final double[] RADIUS = {1, 0.5, 0.2};
    private static final double LEAST_RADIUS = 2e-3;
    /** Part of a step over which differences are taken. */
    private static final double DIFFERENCE = 0.25;
    /** Relative improvement of the error for which no step is made. */
    private static final double ENOUGH = 1e-4;
    /** Share of the expected improvement below which steps become smaller, and above which they become larger. */
    private static final double POOR = 0.25;
    private static final double GOOD = 0.7;
    private static final double SHRINK = 0.3;
    private static final double GROW = 1.7;
    /** Tested values of a turn. */
    private static final int TURNS = 24;

    private final Scene start;
    private final RenderOptions options;
    private final ReferenceImage reference;
    private final MatchSettings settings;
    private final List<LightParameter> parameters;
    private final Renderer renderer;
    private final Progress progress;
    private int stepsDone;

    /** The picture at some values of all parameters, over the cells of a level. */
    private record State(double[] values, MatchContributions contributions, MatchImages images, double[][] factors, double error) {
        // Arrays in a record: written once by their creator, never after.
    }

    /** Values to try, and the error there if the picture changes in proportion. */
    private record Step(double[] values, double expectedError) {
        // Arrays in a record: written once by their creator, never after.
    }

    /** @param scene scene of a picture of any size */
    LightSearch(Scene scene, RenderOptions options, ReferenceImage reference, MatchSettings settings, Progress progress) {
        start = small(scene);
        this.options = options;
        this.reference = reference;
        this.settings = settings;
        this.progress = progress;
        parameters = LightParameter.of(start, Contribution.shining(start).stream().filter(settings::mayChange).toList(), settings);
        renderer = new Renderer(options);
    }

    private static Scene small(Scene scene) {
        int width = scene.picture().width();
        int height = scene.picture().height();
        double scale = Math.min(1, Math.sqrt(PIXELS / ((double) width * height)));
        return scene.withPicture(scene.picture().withSize((int) Math.max(1, Math.round(scale * width)),
                (int) Math.max(1, Math.round(scale * height))).withSampling(SamplingSettings.DEFAULT));
    }

    /**
     * Returns the scene with the best values, before intensities change; its picture is small.
     *
     * @throws IllegalArgumentException if no pixel of the reference counts
     * @throws CancellationException    if the progress requested cancellation
     */
    Scene best() {
        double[] values = new double[parameters.size()];
        for (int level = 0; level < CELLS.length && !parameters.isEmpty(); level++) {
            PixelMeans grid = new PixelMeans(Math.ceilDiv(start.picture().width(), CELLS[level]),
                    Math.ceilDiv(start.picture().height(), CELLS[level]));
            Level search = new Level(grid, TargetCells.all(reference, grid));
            if (level == 0) {
                values = search.turn(values);
            }
            values = search.descend(values, RADIUS[level]);
            stepsDone = (level + 1) * STEPS;
        }
        return LightParameter.edited(start, parameters, values);
    }

    /** Returns the contributions of all lights at some values. */
    private MatchContributions contributions(double[] values) {
        Scene scene = LightParameter.edited(start, parameters, values);
        renderer.render(scene, progress.cancellationOnly());
        return MatchContributions.of(renderer.cache(), options, progress.cancellationOnly());
    }

    private static double[] with(double[] values, int index, double value) {
        double[] changed = values.clone();
        changed[index] = value;
        return changed;
    }

    @Override
    public void close() {
        renderer.close();
    }

    /** Search over cells of one size. */
    private final class Level {
        private final PixelMeans grid;
        private final List<TargetCells> targets;

        Level(PixelMeans grid, List<TargetCells> targets) {
            this.grid = grid;
            this.targets = targets;
        }

        /** Returns the values with each turn at its best of several. */
        double[] turn(double[] values) {
            double[] best = values;
            for (int i = 0; i < parameters.size(); i++) {
                LightParameter parameter = parameters.get(i);
                if (parameter.isTurn()) {
                    State found = state(best);
                    for (int t = 1; t < TURNS; t++) {
                        State state = state(with(values, i, parameter.min() + t * (parameter.max() - parameter.min()) / TURNS));
                        found = state.error < found.error ? state : found;
                    }
                    best = found.values;
                }
            }
            return best;
        }

        /** Returns the values after steps that make the error smaller. */
        double[] descend(double[] values, double firstRadius) {
            State best = state(values);
            double radius = firstRadius;
            for (int step = 0; step < STEPS && radius > LEAST_RADIUS; step++) {
                progress.report(stepsDone + step, CELLS.length * STEPS);
                Step chosen = stepFrom(best, radius);
                double expected = best.error - chosen.expectedError;
                if (expected < ENOUGH * best.error) {
                    break;
                }
                State next = state(chosen.values);
                double gain = (best.error - next.error) / expected;
                if (next.error < best.error) {
                    best = next;
                }
                radius *= gain < POOR ? SHRINK : gain > GOOD ? GROW : 1;
            }
            return best.values;
        }

        private State state(double[] values) {
            MatchContributions contributions = contributions(values);
            MatchImages images = images(contributions);
            LinearMatch match = new LinearMatch(images, List.of(), targets, settings);
            double[][] factors = match.solve(0);
            return new State(values, contributions, images, factors, match.error(factors));
        }

        private MatchImages images(MatchContributions contributions) {
            MatchImages fine = MatchImages.of(contributions, contributions.grid().of(renderer.film()), settings.lights());
            PixelMeans pixels = contributions.grid();
            return new MatchImages(grid, fine.names(), fine.lights().stream().map(image -> grid.of(image, pixels)).toList(),
                    grid.of(fine.rest(), pixels), fine.unseen());
        }

        /** Returns the best step of at most some radius, as if the picture changed in proportion. */
        private Step stepFrom(State state, double radius) {
            List<float[][]> changes = new ArrayList<>();
            for (int i = 0; i < parameters.size(); i++) {
                changes.add(change(state, i, DIFFERENCE * radius));
            }
            LinearMatch match = new LinearMatch(state.images, changes, targets, settings);
            double[][] factors = match.solve(radius);
            double[] values = state.values.clone();
            for (int i = 0; i < values.length; i++) {
                LightParameter parameter = parameters.get(i);
                values[i] = parameter.clamped(values[i] + factors[0][state.images.names().size() + i] * parameter.scale());
            }
            return new Step(values, match.error(factors));
        }

        /** Returns how the picture changes along a parameter, per scale of it. */
        private float[][] change(State state, int index, double step) {
            LightParameter parameter = parameters.get(index);
            double value = state.values[index];
            double other = parameter.clamped(value + step * parameter.scale());
            if (other == value) {
                other = value - step * parameter.scale();
            }
            float[][] change = new float[3][grid.columns() * grid.rows()];
            int light = state.images.names().indexOf(parameter.light());
            if (light < 0) {
                return change;
            }
            MatchContributions moved = contributions(with(state.values, index, other));
            float[][] after = grid.of(moved.image(parameter.light()), moved.grid());
            float[][] before = state.images.lights().get(light);
            double scale = parameter.scale() / (other - value);
            for (int c = 0; c < 3; c++) {
                for (int p = 0; p < change[c].length; p++) {
                    change[c][p] = (float) ((after[c][p] - before[c][p]) * scale * state.factors[c][light]);
                }
            }
            return change;
        }
    }
}
