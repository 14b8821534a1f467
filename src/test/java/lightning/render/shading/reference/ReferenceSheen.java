package lightning.render.shading.reference;

import lightning.render.lobe.SheenLobe;
import lightning.render.shading.LightingEquation;
import lightning.render.trace.MappedSurface;
import lightning.render.trace.SurfacePoint;
import lightning.scene.material.Material;

/** Sheen of materials for {@link ReferenceTracer}. */
final class ReferenceSheen {
    private ReferenceSheen() {}

    /** Returns the first sum of a light: specular and grazing terms with their coat, at the reflectance below the sheen. */
    static float below(Material material, float specular, float grazing) {
        return material.hasSheen() ? (float) material.f0UnderSheen() * specular + grazing : specular;
    }

    /** Returns the second sum of a light: its term of fibers, or the grazing term. */
    static float second(Material material, LightingEquation equation, SurfacePoint hit, float grazing) {
        return material.hasSheen() ? equation.sheen(hit.nx(), hit.ny(), hit.nz(), hit.vx(), hit.vy(), hit.vz(),
                hit.mapped(material).sheenRoughness()) : grazing;
    }

    /** Returns one channel of the share that a surfel with a sheen sends back. @param below share without it */
    static float albedo(Material material, MappedSurface at, int c, float below) {
        if (!material.hasSheen()) {
            return below;
        }
        float mean = SheenLobe.meanAlbedo(at.sheenRoughness());
        float max = Math.max(at.sheen(0), Math.max(at.sheen(1), at.sheen(2)));
        return below * (1 - max * mean) + at.sheen(c) * mean;
    }
}
