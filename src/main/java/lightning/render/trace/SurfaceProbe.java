package lightning.render.trace;

import lightning.base.math.Ray;
import lightning.base.math.Vec3;
import lightning.render.trace.primitive.PrimitiveTable;
import lightning.render.trace.primitive.Surface;
import lightning.render.trace.primitive.TextureLookup;
import lightning.scene.Clarity;
import lightning.scene.Relief;

/**
 * Tells what single rays meet, with all that lighting needs of it.
 *
 * @param materials of the primitives
 */
record SurfaceProbe(PrimitiveTable primitives, MaterialTable materials) {
    /** What a ray meets on a part of a primitive at a distance. */
    SurfacePoint at(int primitive, int part, Ray ray, double t) {
        Vec3 o = ray.origin();
        Vec3 d = ray.direction();
        Surface surface = new Surface();
        surface.at(primitives, primitive, part, o.x(), o.y(), o.z(), d.x(), d.y(), d.z(), t);
        int material = primitives.material[primitive];
        float[] diffuse = {materials.diffuse(material, 0), materials.diffuse(material, 1), materials.diffuse(material, 2)};
        float[] texel = {1, 1, 1};
        if (materials.isTextured(material)) {
            new TextureLookup().at(primitives, primitive, part, materials.texture(material), surface.ownX, surface.ownY, surface.ownZ,
                    texel);
            for (int c = 0; c < 3; c++) {
                diffuse[c] *= texel[c];
            }
        }
        float[] specular = new float[3];
        for (int c = 0; c < 3; c++) {
            specular[c] = materials.metal(material, c) * texel[c] + materials.specular(material, c);
        }
        SurfacePoint.Behind behind = null;
        if (materials.isClear(material)) {
            surface.behind();
            behind = new SurfacePoint.Behind(materials.clarity(material), surface.behindX, surface.behindY, surface.behindZ,
                    way(materials.clarity(material), surface, t));
        }
        return new SurfacePoint(primitive, material, surface.px, surface.py, surface.pz, surface.nx, surface.ny, surface.nz,
                (float) d.x(), (float) d.y(), (float) d.z(), diffuse, specular, texel, behind);
    }

    /** How the normal came about by which a ray's hit is shaded; null where it is the surface's own. */
    NormalSteps steps(int primitive, int part, Ray ray, double t) {
        Vec3 o = ray.origin();
        Vec3 d = ray.direction();
        Surface surface = new Surface();
        surface.at(primitives, primitive, part, o.x(), o.y(), o.z(), d.x(), d.y(), d.z(), t);
        boolean round = surface.isRound(primitives, primitive);
        Relief relief = primitives.relief(primitive);
        Vec3 smooth = round ? surface.unbent(primitives, primitive, true, null) : null;
        Vec3 mapped = relief == null ? null : surface.unbent(primitives, primitive, round, relief);
        Vec3 last = mapped == null ? smooth : mapped;
        boolean bent = last != null
                && !((float) last.x() == surface.nx && (float) last.y() == surface.ny && (float) last.z() == surface.nz);
        return last == null ? null : new NormalSteps(surface.own(), smooth, mapped, bent, round ? surface.lift() : 0);
    }

    /** The way that a ray came inside to a surface that was computed last; below 0 where it came from outside. */
    static float way(Clarity clarity, Surface surface, double t) {
        return surface.isInside() && !clarity.thin() ? (float) t : -1;
    }
}
