package lightning.render.trace;

import java.util.Arrays;
import java.util.EnumMap;
import java.util.Map;
import lightning.base.math.Ray;
import lightning.base.math.Vec3;
import lightning.render.trace.HitRows.ColumnGroup;
import lightning.render.trace.primitive.PrimitiveTable;
import lightning.render.trace.primitive.SurfaceHit;
import lightning.render.trace.primitive.SurfaceTangent;
import lightning.render.trace.primitive.TextureLookup;
import lightning.scene.asset.TextureMap;
import lightning.scene.material.BumpMapping;
import lightning.scene.material.Material;
import lightning.scene.material.Transmission;
import org.jspecify.annotations.Nullable;

/**
 * Computes the surface points of single rays with all data for lighting.
 *
 * @param primitives primitives that rays hit
 * @param materials materials of the primitives
 */
record SurfacePointBuilder(PrimitiveTable primitives, MaterialTable materials) {
    /**
     * Computes the surface point of a ray on a part of a primitive at a distance.
     *
     * @param lifts whether vertex normals lift it
     */
    SurfacePoint surfacePoint(int primitive, int part, Ray ray, double t, boolean lifts) {
        Vec3 d = ray.direction();
        SurfaceHit surface = hit(primitive, part, ray, t, lifts);
        int material = primitives.material[primitive];
        float[] diffuse = {materials.diffuse(material, 0), materials.diffuse(material, 1), materials.diffuse(material, 2)};
        float[] texel = {1, 1, 1};
        if (materials.isTextured(material)) {
            new TextureLookup().lookUp(primitives, primitive, part, materials.texture(material), surface.localX, surface.localY,
                    surface.localZ,
                    texel);
            for (int c = 0; c < 3; c++) {
                diffuse[c] *= texel[c];
            }
        }
        Map<ColumnGroup, float[]> maps = maps(surface, primitive, part);
        if (materials.texels(material).has(ColumnGroup.COAT_NORMAL)) {
            maps.put(ColumnGroup.COAT_NORMAL, coatNormal(primitive, part, ray, t));
        }
        float[] specular = new float[3];
        for (int c = 0; c < 3; c++) {
            specular[c] = materials.metalF0(material, c) * texel[c] + materials.specular(material, c);
        }
        Material look = materials.material(material);
        double roughness = look.roughness();
        if (look.isPrincipled()) {
            var mapped = new MappedSurface();
            mapped.moveTo(look, maps);
            roughness = mapped.roughness();
            if (look.surfaceMaps().changeColors()) {
                var colors = new PrincipledColors(look);
                for (int c = 0; c < 3; c++) {
                    diffuse[c] = colors.diffuse(c, mapped) * texel[c];
                    specular[c] = colors.f0(c, mapped, texel[c]);
                }
            }
        }
        SurfacePoint.BackSide backSide = null;
        if (materials.isTransparent(material)) {
            surface.computeBackPoint();
            backSide = new SurfacePoint.BackSide(materials.transmission(material), surface.backX, surface.backY, surface.backZ,
                    insideDistance(materials.transmission(material), surface, t), look.isFrosted());
        }
        return new SurfacePoint(primitive, material, surface.px, surface.py, surface.pz, surface.nx, surface.ny, surface.nz,
                (float) d.x(), (float) d.y(), (float) d.z(), diffuse, specular, roughness, texel, maps, backSide);
    }

    private Map<ColumnGroup, float[]> maps(SurfaceHit surface, int primitive, int part) {
        Map<ColumnGroup, float[]> texels = new EnumMap<>(ColumnGroup.class);
        for (ColumnGroup group : ColumnGroup.TEXELS) {
            TextureMap map = materials.map(group, primitives.material[primitive]);
            if (map != null && group != ColumnGroup.TEXEL && group != ColumnGroup.COAT_NORMAL) {
                float[] texel = new float[3];
                new TextureLookup().lookUpMap(primitives, primitive, part, map, surface.localX, surface.localY, surface.localZ, texel);
                int first = group.firstChannel(materials.material(primitives.material[primitive]));
                texels.put(group, Arrays.copyOfRange(texel, first, first + group.columnCount()));
            }
        }
        if (materials.texels(primitives.material[primitive]).has(ColumnGroup.TANGENT)) {
            float[] tangent = new float[3];
            new SurfaceTangent().compute(primitives, primitive, part, surface.localX, surface.localY, surface.localZ, surface.nx,
                    surface.ny, surface.nz, tangent);
            texels.put(ColumnGroup.TANGENT, tangent);
        }
        return texels;
    }

    private float[] coatNormal(int primitive, int part, Ray ray, double t) {
        SurfaceHit surface = hit(primitive, part, ray, t);
        Vec3 d = ray.direction();
        surface.computeCoatNormal(primitives, primitive, materials.material(primitives.material[primitive]).coatNormals().map(), d.x(),
                d.y(),
                d.z());
        return new float[] {surface.nx, surface.ny, surface.nz};
    }

    /** Returns the place on the shape that a ray hits at a distance. */
    SurfaceLocation location(int primitive, int part, Ray ray, double t) {
        SurfaceHit surface = hit(primitive, part, ray, t);
        double[] uv = new double[2];
        new TextureLookup().writeCoordinates(primitives, primitive, part, surface.localX, surface.localY, surface.localZ, uv);
        return new SurfaceLocation(ray.origin().plus(ray.direction().times(t)), new Vec3(surface.localX, surface.localY, surface.localZ),
                uv[0], uv[1]);
    }

    /** Returns the surface that a ray hits at a distance. */
    SurfaceHit hit(int primitive, int part, Ray ray, double t) {
        return hit(primitive, part, ray, t, true);
    }

    private SurfaceHit hit(int primitive, int part, Ray ray, double t, boolean lifts) {
        Vec3 o = ray.origin();
        Vec3 d = ray.direction();
        SurfaceHit surface = new SurfaceHit();
        surface.lifts = lifts;
        surface.compute(primitives, primitive, part, o.x(), o.y(), o.z(), d.x(), d.y(), d.z(), t);
        return surface;
    }

    /** Returns the steps from the geometric normal to the shading normal at a ray's hit; null if both are equal. */
    @Nullable
    NormalSteps normalSteps(int primitive, int part, Ray ray, double t) {
        SurfaceHit surface = hit(primitive, part, ray, t);
        boolean isSmooth = surface.isSmooth(primitives, primitive);
        BumpMapping bumpMapping = primitives.bumpMapping(primitive);
        Vec3 smooth = isSmooth ? surface.unbentNormal(primitives, primitive, true, null) : null;
        Vec3 bumped = bumpMapping == null ? null : surface.unbentNormal(primitives, primitive, isSmooth, bumpMapping);
        Vec3 last = bumped == null ? smooth : bumped;
        boolean isBent = last != null
                && !((float) last.x() == surface.nx && (float) last.y() == surface.ny && (float) last.z() == surface.nz);
        return last == null ? null
                : new NormalSteps(surface.geometricNormal(), smooth, bumped, isBent, isSmooth ? surface.liftDistance() : 0);
    }

    /** Returns the length inside the body of the ray to the surface computed last; below 0 if it came from outside. */
    static float insideDistance(Transmission transmission, SurfaceHit surface, double t) {
        return surface.isInside() && !transmission.thin() ? (float) t : -1;
    }
}
