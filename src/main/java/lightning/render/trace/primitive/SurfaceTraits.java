package lightning.render.trace.primitive;

import java.util.List;
import java.util.Map;
import java.util.function.Function;
import java.util.function.IntFunction;
import java.util.function.Predicate;
import lightning.scene.AlphaCutout;
import lightning.scene.BumpMapping;
import lightning.scene.Material;
import lightning.scene.Shape;
import lightning.scene.Stage;
import lightning.scene.Transmission;

/** What materials of primitives say of where rays go there: what bends normals, what passes through, and what is cut out. */
final class SurfaceTraits {
    /** What bends the normals of each primitive, null for nothing; null where there is nothing at all. */
    private final BumpMapping[] bumpMappings;
    /** What passes through each primitive, null for nothing; null where there is nothing at all. */
    private final Transmission[] transmissions;
    /** What is cut out of each primitive, null for nothing; null where there is nothing at all. */
    private final AlphaCutout[] cutouts;
    /** The material of each primitive that light passes, null for others; null where it passes none. */
    private final Material[] shadowTints;

    SurfaceTraits(Stage stage) {
        bumpMappings = forEachShape(stage, Material::bumpMapping, r -> !r.isFlat(), BumpMapping[]::new);
        transmissions = forEachShape(stage, Material::transmission, Transmission::isTransparent, Transmission[]::new);
        cutouts = forEachShape(stage, Material::cutout, AlphaCutout::isActive, AlphaCutout[]::new);
        shadowTints = forEachShape(stage, m -> m, m -> m.transmission().tintsShadows(), Material[]::new);
    }

    private static <T> T[] forEachShape(Stage stage, Function<Material, T> trait, Predicate<T> hasEffect, IntFunction<T[]> array) {
        Map<String, Material> materials = stage.materialsByName();
        if (materials.values().stream().map(trait).noneMatch(hasEffect)) {
            return null;
        }
        List<Shape> shapes = stage.shapes();
        return shapes.stream().map(s -> trait.apply(materials.get(s.material()))).map(t -> hasEffect.test(t) ? t : null).toArray(array);
    }

    /** What bends the normals of primitive {@code s}; null for nothing. */
    BumpMapping bumpMapping(int s) {
        return bumpMappings == null ? null : bumpMappings[s];
    }

    /** What passes through primitive {@code s}; null for nothing. */
    private Transmission transmission(int s) {
        return transmissions == null ? null : transmissions[s];
    }

    /** What is cut out of primitive {@code s}; null for nothing. */
    AlphaCutout cutout(int s) {
        return cutouts == null ? null : cutouts[s];
    }

    /** The material of primitive {@code s} where light on its way to a point passes it; else null. */
    Material shadowTint(int s) {
        return shadowTints == null ? null : shadowTints[s];
    }

    /** Whether light passes any primitive. */
    boolean hasShadowTints() {
        return shadowTints != null;
    }

    /** Whether light passes primitive {@code s} as it passes primitive {@code t} of others. */
    boolean hasSameShadowTint(int s, SurfaceTraits o, int t) {
        Material one = shadowTint(s);
        Material other = o.shadowTint(t);
        return one == other || one != null && other != null && one.hasSameShadowTint(other) && hasSameNormals(s, o, t);
    }

    /** Whether anything is cut out of any primitive. */
    boolean hasCutouts() {
        return cutouts != null;
    }

    /** Whether primitive {@code s} has the holes of primitive {@code t} of others. */
    boolean hasSameCutout(int s, SurfaceTraits o, int t) {
        AlphaCutout one = cutout(s);
        AlphaCutout other = o.cutout(t);
        return one == other || one != null && other != null && one.hasSameHoles(other);
    }

    /** Whether rays go on behind primitive {@code s} as they do behind primitive {@code t} of others. */
    boolean refractsLike(int s, SurfaceTraits o, int t) {
        Transmission one = transmission(s);
        Transmission other = o.transmission(t);
        return one == other || one != null && other != null && one.refractsLike(other);
    }

    /** Whether normals of primitive {@code s} are bent as those of primitive {@code t} of others. */
    boolean hasSameNormals(int s, SurfaceTraits o, int t) {
        BumpMapping one = bumpMapping(s);
        BumpMapping other = o.bumpMapping(t);
        return one == other || one != null && other != null && one.hasSameNormals(other);
    }
}
