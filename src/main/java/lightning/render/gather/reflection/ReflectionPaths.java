package lightning.render.gather.reflection;

import static java.util.Objects.requireNonNull;

import java.io.IOException;
import java.util.Arrays;
import java.util.List;
import lightning.render.column.ColumnReader;
import lightning.render.column.ColumnWriter;
import lightning.render.gather.cell.CellKeys;
import lightning.render.gather.cell.SkyCells;
import lightning.render.gather.glow.GlowShapes;
import lightning.render.gather.point.PointFilter;
import lightning.render.gather.ray.FilmKernel;
import lightning.render.gather.ray.FilmLight;
import lightning.render.gather.ray.RaySums;
import lightning.scene.material.Material;
import org.jspecify.annotations.Nullable;

/**
 * Paths of blurred reflections: from surfels and the sky to reflection points to rows. Immutable.
 *
 * @param links          what the rays meet
 * @param steps          width of the cells of directions by material; 0 for materials that do not blur reflections
 * @param glows          objects that were shown glowing
 * @param surfelOfDetail for each part of a surfel the surfel that it belongs to
 */
public record ReflectionPaths(ReflectionPoints points, ReflectionLinks links, ReflectionGroup[] groups, PointFilter filter,
        float[] steps, GlowShapes glows, int[] surfelOfDetail, PointFilter surfelFilter, ReflectionOrigins origins) {
    public void writeTo(ColumnWriter out) throws IOException {
        points.writeTo(out);
        links.writeTo(out);
        filter.writeTo(out);
        out.writeArray(steps);
        out.writeArray(surfelOfDetail);
        surfelFilter.writeTo(out);
        origins.writeTo(out);
    }

    /**
     * @param glows     objects that were shown glowing
     * @param materials all materials
     */
    public static ReflectionPaths readFrom(ColumnReader in, CellKeys keys, GlowShapes glows, List<Material> materials)
            throws IOException {
        ReflectionPoints points = ReflectionPoints.readFrom(in, keys);
        ReflectionLinks links = ReflectionLinks.readFrom(in);
        PointFilter filter = PointFilter.readFrom(in);
        float[] steps = in.readFloats();
        return new ReflectionPaths(points, links, ReflectionGroup.of(points, steps, materials), filter, steps, glows, in.readInts(),
                PointFilter.readFrom(in), ReflectionOrigins.readFrom(in));
    }

    /** Returns the materials of the groups. */
    public List<Material> materials() {
        return Arrays.stream(groups).map(group -> group.material).toList();
    }

    /** Returns the rays of lobes along each side of the grid of a point's rays. */
    int side() {
        return (int) Math.round(Math.sqrt(links.raysPerPoint() - ReflectionCaster.aimedRays(glows)));
    }

    /**
     * Writes the mean light that points {@code first … end − 1} and their copies reflect: {@code color} with the weights that the reflectance
     * multiplies, {@code white} with those that no color multiplies.
     *
     * @param shown  light of each surfel, then of each cell of the sky, then that of rays that leave the scene if it is the same in all directions
     * @param hasSky whether any film's sky is not
     */
    public void writeMeans(FilmLight shown, boolean hasSky, FilmKernel kernel, FilmLight color, FilmLight white, int first, int end) {
        RaySums sums = new RaySums(kernel);
        SkyParts sky = hasSky ? new SkyParts(this, shown, shown.numbers() - SkyCells.NUMBERS) : null;
        for (int p = first; p < end; p++) {
            if (sky != null) {
                sky.moveTo(p, requireNonNull(groups[points.material[p]].lobes));
            }
            links.writeMean(p, shown, sky, sums, color, white);
            int endCopy = p + 1 < count() ? origins.firstCopy()[p + 1] : links.points();
            for (int copy = origins.firstCopy()[p]; copy < endCopy; copy++) {
                links.writeMean(copy, shown, sky, sums, color, white);
            }
        }
    }

    /** Returns the number of reflection points without copies. */
    public int count() {
        return points.count();
    }

    /**
     * Returns the number of the last surfel that reflections meet, and 1; 0 if they meet none.
     *
     * @param surfels number of all surfels, with their parts
     */
    public int foundSurfels(int surfels) {
        int whole = surfels - surfelOfDetail.length;
        int found = 0;
        for (int ray = 0; ray < links.rayCount(); ray++) {
            int surfel = links.surfel(ray);
            found = surfel >= surfels ? found : Math.max(found, 1 + (surfel < whole ? surfel : surfelOfDetail[surfel - whole]));
        }
        return found;
    }

    /** Returns the points of a material; null if it does not blur reflections. */
    @Nullable
    public ReflectionGroup group(int material) {
        return material < steps.length && steps[material] > 0 ? groups[material] : null;
    }

    /**
     * Writes the means over the neighbors of points {@code first … end − 1}; parameters as {@link lightning.render.gather.GatherStructure#filter}.
     */
    public void filter(FilmLight from, FilmKernel kernel, float[][][] to, int first, int end) {
        filter.apply(from, kernel, to, first, end);
    }

    /** Returns the number of surfels that gather light, which come first. */
    public int gatheringSurfels() {
        return surfelFilter.start().length - 1;
    }

    /** Writes the means over neighboring surfels {@code first … end − 1} of those that gather light; parameters as above. */
    public void filterSurfels(FilmLight from, FilmKernel kernel, float[][][] to, int first, int end) {
        surfelFilter.apply(from, kernel, to, first, end);
    }

    public long bytes() {
        return surfelFilter.bytes() + points.bytes() + links.bytes() + filter.bytes() + 68L * points.count() + 4L * surfelOfDetail.length
                + origins.bytes();
    }
}
