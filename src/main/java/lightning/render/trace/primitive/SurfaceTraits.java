package lightning.render.trace.primitive;

import java.util.List;
import java.util.Map;
import java.util.function.Function;
import java.util.function.IntFunction;
import java.util.function.Predicate;
import lightning.scene.Stage;
import lightning.scene.material.AlphaCutout;
import lightning.scene.material.BumpMapping;
import lightning.scene.material.CoatNormals;
import lightning.scene.material.Material;
import lightning.scene.material.Transmission;
import lightning.scene.node.Shape;
import org.jspecify.annotations.Nullable;

/** Material properties of primitives that affect rays: bump mapping, transmission and cutouts. */
final class SurfaceTraits {
    /** Bump mapping of each primitive, null for none; null if there is none at all. */
    private final @Nullable BumpMapping @Nullable [] bumpMappings;
    /** Normals of the coat of each primitive, null if they are those of the surface; null if there are none at all. */
    private final @Nullable CoatNormals @Nullable [] coatNormals;
    /** Transmission of each primitive that refracts rays, null for none; null if there is none at all. */
    private final @Nullable Transmission @Nullable [] transmissions;
    /** Cutout of each primitive, null for none; null if there is none at all. */
    private final @Nullable AlphaCutout @Nullable [] cutouts;
    /** Material of each primitive that tints shadow rays, null for others; null if there is none at all. */
    private final @Nullable Material @Nullable [] shadowTints;

    SurfaceTraits(Stage stage) {
        bumpMappings = forEachShape(stage, Material::bumpMapping, r -> !r.isFlat(), BumpMapping[]::new);
        coatNormals = forEachShape(stage, Material::coatNormals, n -> n != CoatNormals.NONE, CoatNormals[]::new);
        transmissions = forEachShape(stage, m -> m.isClear() ? m.transmission() : Transmission.NONE, Transmission::isTransparent,
                Transmission[]::new);
        cutouts = forEachShape(stage, Material::cutout, AlphaCutout::isActive, AlphaCutout[]::new);
        shadowTints = forEachShape(stage, m -> m, m -> m.transmission().tintsShadows(), Material[]::new);
    }

    private static <T> @Nullable T @Nullable [] forEachShape(Stage stage, Function<Material, T> trait, Predicate<T> hasEffect,
            IntFunction<T[]> array) {
        Map<String, Material> materials = stage.materialsByName();
        if (materials.values().stream().map(trait).noneMatch(hasEffect)) {
            return null;
        }
        List<Shape> shapes = stage.shapes();
        return shapes.stream().map(s -> trait.apply(materials.get(s.material()))).map(t -> hasEffect.test(t) ? t : null).toArray(array);
    }

    /** Returns the bump mapping of primitive {@code s}; null for none. */
    @Nullable
    BumpMapping bumpMapping(int s) {
        return bumpMappings == null ? null : bumpMappings[s];
    }

    /** Returns the transmission of primitive {@code s} if it refracts rays, otherwise null. */
    private @Nullable Transmission transmission(int s) {
        return transmissions == null ? null : transmissions[s];
    }

    /** Returns the cutout of primitive {@code s}; null for none. */
    @Nullable
    AlphaCutout cutout(int s) {
        return cutouts == null ? null : cutouts[s];
    }

    /** Returns the material of primitive {@code s} if it tints shadow rays, otherwise null. */
    @Nullable
    Material shadowTint(int s) {
        return shadowTints == null ? null : shadowTints[s];
    }

    /** Returns whether any primitive tints shadow rays. */
    boolean hasShadowTints() {
        return shadowTints != null;
    }

    /** Returns whether primitive {@code s} tints shadow rays like primitive {@code t} of another table. */
    boolean hasSameShadowTint(int s, SurfaceTraits o, int t) {
        Material one = shadowTint(s);
        Material other = o.shadowTint(t);
        return one == other || one != null && other != null && one.hasSameShadowTint(other) && hasSameNormals(s, o, t);
    }

    /** Returns whether any primitive has cutouts. */
    boolean hasCutouts() {
        return cutouts != null;
    }

    /** Returns whether primitive {@code s} has the cutouts of primitive {@code t} of another table. */
    boolean hasSameCutout(int s, SurfaceTraits o, int t) {
        AlphaCutout one = cutout(s);
        AlphaCutout other = o.cutout(t);
        return one == other || one != null && other != null && one.hasSameHoles(other);
    }

    /** Returns whether primitive {@code s} refracts rays like primitive {@code t} of another table. */
    boolean refractsLike(int s, SurfaceTraits o, int t) {
        Transmission one = transmission(s);
        Transmission other = o.transmission(t);
        return one == other || one != null && other != null && one.refractsLike(other);
    }

    private CoatNormals coatNormals(int s) {
        CoatNormals found = coatNormals == null ? null : coatNormals[s];
        return found == null ? CoatNormals.NONE : found;
    }

    /** Returns whether primitive {@code s} has the bump mapping and the normals of the coat of primitive {@code t} of another table. */
    boolean hasSameNormals(int s, SurfaceTraits o, int t) {
        BumpMapping one = bumpMapping(s);
        BumpMapping other = o.bumpMapping(t);
        return (one == other || one != null && other != null && one.hasSameNormals(other)) && coatNormals(s).areSame(o.coatNormals(t));
    }
}
