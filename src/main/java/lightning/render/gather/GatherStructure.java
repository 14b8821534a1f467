package lightning.render.gather;

import java.io.IOException;
import java.util.Arrays;
import java.util.List;
import java.util.stream.IntStream;
import lightning.render.column.ColumnReader;
import lightning.render.column.ColumnWriter;
import lightning.render.gather.cell.CellKeys;
import lightning.render.gather.cell.SurfaceColumns;
import lightning.render.gather.glow.GlowAim;
import lightning.render.gather.glow.GlowPaths;
import lightning.render.gather.glow.GlowShapes;
import lightning.render.gather.point.GatherPoints;
import lightning.render.gather.ray.FilmKernel;
import lightning.render.gather.ray.FilmLight;
import lightning.render.gather.ray.RayLinks;
import lightning.render.gather.ray.RaySources;
import lightning.render.gather.ray.TiltedFacets;
import lightning.render.gather.reflection.ReflectionPaths;
import lightning.render.gather.rim.RimLinks;
import lightning.render.trace.Geometry;
import lightning.render.trace.HitRows;
import lightning.render.trace.MaterialTable;
import lightning.scene.GatherSettings;
import lightning.scene.Scene;
import lightning.scene.material.Material;
import org.jspecify.annotations.Nullable;

/**
 * Paths of diffuse indirect light: from surfels to surfels to gather points to rows. Determined by shapes, camera and settings alone.
 * Immutable.
 *
 * <p>A surfel is a small part of a surface. It is lit at one place, its row, like every other row.
 *
 * @param pointLinks    surfels that the rays of gather points hit
 * @param rims          what additional rays of gather points meet, through the rims of openings
 * @param surfelLinks   surfels that the rays of the first surfels hit; later surfels have no rays
 * @param surfelNormals normals of the surfaces of surfels that cast rays
 * @param glow          paths from small glowing objects
 * @param kept          for each surfel before an edit its number now, −1 if its row is not the same; null if this structure contains
 *                      all rows, as after a first build; otherwise it lacks those of these surfels
 * @param reflections   paths of blurred reflections; null for none
 * @param isIndirect    whether surfels send light to gather points
 * @param bounces       diffuse bounces between a light and a gather point, or 1 if surfels send light to reflections only
 * @param rays          rays that were cast to build it
 */
public record GatherStructure(GatherPoints points, RayLinks pointLinks, RimLinks rims, RayLinks surfelLinks, SurfelRows surfelRows,
        TiltedFacets surfelNormals, GlowPaths glow, int @Nullable [] kept, @Nullable ReflectionPaths reflections, boolean isIndirect,
        int bounces, GatherRays rays) {
    /**
     * Cells and objects to which stored paths refer.
     *
     * @param keys   of the cells of the gather points
     * @param shapes glowing objects at which rays are aimed
     * @param seen   those at which rays of reflections are aimed
     * @param materials materials of reflection points, by number; none without these
     */
    public record Metadata(CellKeys keys, GlowShapes shapes, GlowShapes seen, List<Material> materials) {
        /** Returns what the paths of a scene refer to when they are traced. */
        public static Metadata of(Geometry geometry, Scene scene, GatherSettings settings) {
            MaterialTable table = geometry.materials();
            return new Metadata(new CellKeys(scene, settings), settings.isIndirect() ? GlowShapes.of(geometry) : GlowShapes.none(),
                    settings.reflections() ? GlowShapes.seen(geometry, table) : GlowShapes.none(),
                    settings.reflections() ? IntStream.range(0, table.count()).mapToObj(table::material).toList() : List.of());
        }

        /** Returns whether paths that refer to this may refer to another instead: they have the same camera and settings. */
        public boolean isSame(Metadata other) {
            return shapes.areSame(other.shapes) && seen.areSame(other.seen) && materials.equals(other.materials);
        }
    }

    /** Returns what stored paths refer to. */
    public Metadata metadata() {
        return new Metadata(points.sources().keys(), glow.shapes(), reflections == null ? GlowShapes.none() : reflections.glows(),
                reflections == null ? List.of() : reflections.materials());
    }

    /** Writes these paths, which must contain all rows. */
    public void writeTo(ColumnWriter out) throws IOException {
        points.writeTo(out);
        pointLinks.writeTo(out);
        rims.writeTo(out);
        surfelLinks.writeTo(out);
        surfelRows.writeTo(out);
        surfelNormals.writeTo(out);
        glow.writeTo(out);
        out.writeInt(reflections == null ? 0 : 1);
        if (reflections != null) {
            reflections.writeTo(out);
        }
        out.writeInt(isIndirect ? 1 : 0);
        out.writeInt(bounces);
        rays.writeTo(out);
    }

    /**
     * Reads paths.
     *
     * @throws IOException if the data is truncated
     */
    public static GatherStructure readFrom(ColumnReader in, Metadata metadata) throws IOException {
        return new GatherStructure(GatherPoints.readFrom(in, metadata.keys), RayLinks.readFrom(in), RimLinks.readFrom(in),
                RayLinks.readFrom(in),
                SurfelRows.readFrom(in), TiltedFacets.readFrom(in), GlowPaths.readFrom(in, metadata.shapes), null,
                in.readInt() == 0 ? null : ReflectionPaths.readFrom(in, metadata.keys, metadata.seen, metadata.materials),
                in.readInt() != 0, in.readInt(),
                GatherRays.readFrom(in));
    }

    /**
     * Returns these paths with all rows.
     *
     * @param rows    rows of all surfels in blocks
     * @param numbers surfel of each parent in each block
     */
    public GatherStructure withSurfels(HitRows[] rows, int[][] numbers) {
        return new GatherStructure(points, pointLinks, rims, surfelLinks,
                new SurfelRows(rows, numbers, surfelRows.near(), surfelRows.count()),
                surfelNormals, glow, null, reflections, isIndirect, bounces, rays);
    }

    public int pointCount() {
        return points.count();
    }

    public int surfelCount() {
        return surfelRows.count();
    }

    /** Returns the rows of the surfels in blocks of at most 1024; {@code parent} is an index of {@link #numbers}. */
    public HitRows[] surfels() {
        return surfelRows.blocks().clone();
    }

    /** Returns the surfel of each parent in a block. Callers must not modify it. */
    public int[] numbers(int block) {
        return surfelRows.numbers()[block];
    }

    /** Returns the points that the surfels are, with their places given. */
    public RaySources surfelSources(CellKeys keys, SurfaceColumns places) {
        RaySources sources = new RaySources(keys, places, true);
        sources.setNormals(surfelNormals);
        return sources;
    }

    /** Returns whether the cell of a surfel is small. */
    public boolean isNear(int surfel) {
        return surfelRows.near().get(surfel);
    }

    /**
     * Returns whether rays are aimed at all glowing objects of a scene with the same shapes, camera and settings, and as many at each as in
     * paths built for it. An object that no longer glows adds nothing.
     *
     * @param materials materials of that scene
     */
    public boolean canServe(Geometry geometry, MaterialTable materials) {
        if (reflections != null && !reflections.glows().areSame(GlowShapes.seen(geometry, materials))) {
            return false;
        }
        if (!isIndirect) {
            return true;
        }
        GlowShapes others = GlowShapes.of(geometry, materials);
        return glow.shapes().contain(others) && (others.count() == 0 || aim(pointLinks, glow.shapes()).isAsDense(aim(pointLinks, others))
                && aim(surfelLinks, glow.shapes()).isAsDense(aim(surfelLinks, others)));
    }

    private static GlowAim aim(RayLinks links, GlowShapes shapes) {
        return new GlowAim(shapes, links.raysPerPoint());
    }

    /**
     * Writes the means over the neighbors of gather points {@code first … end − 1}.
     *
     * @param from light of each point
     * @param to   receives red, green and blue of each film
     */
    public void filter(FilmLight from, FilmKernel kernel, float[][][] to, int first, int end) {
        points.filter().apply(from, kernel, to, first, end);
    }

    /** Returns no light at all points, in as many columns as {@link lightning.render.shading.IndirectSolver} computes. */
    public float[][] noLight() {
        float[][] light = new float[reflections == null ? 3 : 9][];
        Arrays.setAll(light, c -> new float[c < 3 || reflections == null ? pointCount() : reflections.count()]);
        return light;
    }

    /** Returns the bytes of all columns. */
    public long bytes() {
        return pointBytes() + surfelBytes() + (reflections == null ? 0 : reflections.bytes());
    }

    /** Returns the bytes of the gather points, their filter and their links. */
    public long pointBytes() {
        return pointLinks.bytes() + rims.bytes() + points.filter().bytes() + points.groups().bytes() + points.barriers().bytes()
                + 40L * points.count()
                + points.sources().normalBytes() + glow.pointBytes();
    }

    /** Returns the bytes that it took at most while it was built. */
    public long buildBytes() {
        return bytes() + pointLinks.buildBytes() + surfelLinks.buildBytes()
                + (reflections == null ? 0 : reflections.links().buildBytes());
    }

    /** Returns the share of gather points, their filter and their links in these bytes. */
    public long pointBuildBytes() {
        return pointBytes() + pointLinks.buildBytes();
    }

    private long surfelBytes() {
        return surfelLinks.bytes() + surfelRows.bytes() + surfelNormals.bytes() + glow.surfelBytes();
    }
}
