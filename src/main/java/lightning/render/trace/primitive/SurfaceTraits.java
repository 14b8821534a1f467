package lightning.render.trace.primitive;

import java.util.List;
import java.util.Map;
import java.util.function.Function;
import java.util.function.IntFunction;
import java.util.function.Predicate;
import lightning.scene.Clarity;
import lightning.scene.Cutout;
import lightning.scene.Material;
import lightning.scene.Relief;
import lightning.scene.Shape;
import lightning.scene.Stage;

/** What materials of primitives say of where rays go there: what bends normals, what passes through, and what is cut out. */
final class SurfaceTraits {
    /** What bends the normals of each primitive, null for nothing; null where there is nothing at all. */
    private final Relief[] reliefs;
    /** What passes through each primitive, null for nothing; null where there is nothing at all. */
    private final Clarity[] clarities;
    /** What is cut out of each primitive, null for nothing; null where there is nothing at all. */
    private final Cutout[] cutouts;
    /** The material of each primitive that light passes, null for others; null where it passes none. */
    private final Material[] tints;

    SurfaceTraits(Stage stage) {
        reliefs = each(stage, Material::relief, r -> !r.isFlat(), Relief[]::new);
        clarities = each(stage, Material::clarity, Clarity::isClear, Clarity[]::new);
        cutouts = each(stage, Material::cutout, Cutout::cuts, Cutout[]::new);
        tints = each(stage, m -> m, m -> m.clarity().tintsLight(), Material[]::new);
    }

    private static <T> T[] each(Stage stage, Function<Material, T> trait, Predicate<T> counts, IntFunction<T[]> array) {
        Map<String, Material> materials = stage.materialsByName();
        if (materials.values().stream().map(trait).noneMatch(counts)) {
            return null;
        }
        List<Shape> shapes = stage.shapes();
        return shapes.stream().map(s -> trait.apply(materials.get(s.material()))).map(t -> counts.test(t) ? t : null).toArray(array);
    }

    /** What bends the normals of primitive {@code s}; null for nothing. */
    Relief relief(int s) {
        return reliefs == null ? null : reliefs[s];
    }

    /** What passes through primitive {@code s}; null for nothing. */
    private Clarity clarity(int s) {
        return clarities == null ? null : clarities[s];
    }

    /** What is cut out of primitive {@code s}; null for nothing. */
    Cutout cutout(int s) {
        return cutouts == null ? null : cutouts[s];
    }

    /** The material of primitive {@code s} where light on its way to a point passes it; else null. */
    Material tint(int s) {
        return tints == null ? null : tints[s];
    }

    /** Whether light passes any primitive. */
    boolean haveTints() {
        return tints != null;
    }

    /** Whether light passes primitive {@code s} as it passes primitive {@code t} of others. */
    boolean passesLightAs(int s, SurfaceTraits o, int t) {
        Material one = tint(s);
        Material other = o.tint(t);
        return one == other || one != null && other != null && one.passesLightAs(other) && isBentAs(s, o, t);
    }

    /** Whether anything is cut out of any primitive. */
    boolean haveCutouts() {
        return cutouts != null;
    }

    /** Whether primitive {@code s} has the holes of primitive {@code t} of others. */
    boolean hasHolesOf(int s, SurfaceTraits o, int t) {
        Cutout one = cutout(s);
        Cutout other = o.cutout(t);
        return one == other || one != null && other != null && one.hasHolesOf(other);
    }

    /** Whether rays go on behind primitive {@code s} as they do behind primitive {@code t} of others. */
    boolean leadsRaysAs(int s, SurfaceTraits o, int t) {
        Clarity one = clarity(s);
        Clarity other = o.clarity(t);
        return one == other || one != null && other != null && one.leadsRaysAs(other);
    }

    /** Whether normals of primitive {@code s} are bent as those of primitive {@code t} of others. */
    boolean isBentAs(int s, SurfaceTraits o, int t) {
        Relief one = relief(s);
        Relief other = o.relief(t);
        return one == other || one != null && other != null && one.hasNormalsOf(other);
    }
}
