package lightning.render.shading;

import lightning.base.work.Progress;
import lightning.base.work.WorkerPool;
import lightning.render.gather.GatherStructure;
import lightning.render.gather.RayLinks;
import lightning.scene.IndirectSettings;
import lightning.scene.Scene;

/**
 * Computes the light at gather points from the direct light of surfels, by look-ups along the paths of a {@link GatherStructure}.
 *
 * <pre>
 * B₁ = glow + albedo · D                     D = the lights' diffuse sum at a surfel
 * Bₙ = glow + albedo · (D + mean of Bₙ₋₁ over the surfel's rays)
 * E  = filter(mean of B over the gather point's rays)
 * </pre>
 *
 * <p>Rays are cosine-distributed, so the plain mean is the irradiance in units of the lights' diffuse sum. Sums over rays are exact to
 * a double, in the order of the rays. All lights are added before anything is gathered, so the cost does not grow with their number.
 */
public final class IndirectSolver {
    private static final int BATCH = 512;

    private final GatherStructure structure;
    private final WorkerPool workers;
    private final Progress progress;
    /** Light of a ray that leaves the scene: red, green, blue. */
    private final float[] background;

    public IndirectSolver(GatherStructure structure, Scene scene, WorkerPool workers, Progress progress) {
        this.structure = structure;
        this.workers = workers;
        this.progress = progress.cancellationOnly();
        boolean lit = scene.picture().indirect().orElse(IndirectSettings.DEFAULT).background() && scene.world().environment().isEmpty();
        background = lit ? new float[] {(float) scene.world().background().r(), (float) scene.world().background().g(),
            (float) scene.world().background().b()} : new float[3];
    }

    /**
     * Returns the light at all gather points: red, green, blue.
     *
     * @param direct lights' diffuse sum at each surfel
     * @param albedo of each surfel
     * @param glow   light that each surfel emits itself
     * @throws java.util.concurrent.CancellationException if the progress requested cancellation
     */
    public float[][] solve(float[][] direct, float[][] albedo, float[][] glow) {
        float[][] light = new float[3][];
        for (int c = 0; c < 3; c++) {
            light[c] = gather(radiosity(direct[c], albedo[c], glow[c], c), c);
        }
        return light;
    }

    private float[] radiosity(float[] direct, float[] albedo, float[] glow, int channel) {
        int surfels = structure.surfelCount();
        float[] radiosity = new float[surfels];
        for (int s = 0; s < surfels; s++) {
            radiosity[s] = glow[s] + albedo[s] * direct[s];
        }
        for (int bounce = 2; bounce <= structure.bounces(); bounce++) {
            float[] before = radiosity;
            float[] after = new float[surfels];
            int linked = structure.surfelLinks().points();
            run(surfels, (from, to) -> {
                for (int s = from; s < to; s++) {
                    float gathered = s < linked ? mean(structure.surfelLinks(), s, before, channel) : 0;
                    after[s] = glow[s] + albedo[s] * (direct[s] + gathered);
                }
            });
            radiosity = after;
        }
        return radiosity;
    }

    private float[] gather(float[] radiosity, int channel) {
        int points = structure.pointCount();
        float[] gathered = new float[points];
        run(points, (from, to) -> {
            for (int p = from; p < to; p++) {
                gathered[p] = mean(structure.pointLinks(), p, radiosity, channel);
            }
        });
        float[] filtered = new float[points];
        run(points, (from, to) -> structure.filter(gathered, filtered, from, to));
        return filtered;
    }

    /** Returns the mean radiosity that a point's rays meet. */
    private float mean(RayLinks links, int point, float[] radiosity, int channel) {
        int rays = links.raysPerPoint();
        int[] surfels = links.surfels();
        float[] tint = links.tints() == null ? null : links.tints()[channel];
        double sum = 0;
        for (int ray = point * rays; ray < point * rays + rays; ray++) {
            float met = surfels[ray] == RayLinks.MISS ? background[channel] : radiosity[surfels[ray]];
            sum += tint == null ? met : met * tint[ray];
        }
        return (float) (sum / rays);
    }

    private interface Part {
        void run(int from, int to);
    }

    private void run(int count, Part part) {
        workers.run(Math.ceilDiv(count, BATCH), (_, job) -> part.run(job * BATCH, Math.min(count, job * BATCH + BATCH)), progress);
    }
}
