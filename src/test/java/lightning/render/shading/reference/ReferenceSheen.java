package lightning.render.shading.reference;

import lightning.render.lobe.SheenLobe;
import lightning.render.shading.LightingEquation;
import lightning.render.shading.PrincipledMaterial;
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
                PrincipledMaterial.of(material).sheen()) : grazing;
    }

    /** Returns one channel of the share that a surfel with a sheen sends back. @param below share without it */
    static float albedo(Material material, int c, float below) {
        if (!material.hasSheen()) {
            return below;
        }
        float mean = new SheenLobe(material.sheen().roughness()).meanAlbedo();
        float[] color = {(float) material.sheen().color().r(), (float) material.sheen().color().g(), (float) material.sheen().color().b()};
        return below * (1 - (float) material.sheen().color().max() * mean) + color[c] * mean;
    }
}
