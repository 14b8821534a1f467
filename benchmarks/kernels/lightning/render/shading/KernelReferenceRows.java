package lightning.render.shading;

import java.util.Map;
import lightning.base.math.Vec3;
import lightning.render.engine.KernelAgreement;
import lightning.render.relight.paper.RatioRows;
import lightning.render.shading.composition.RowKernels;
import lightning.render.shading.layer.LightRows;
import lightning.render.trace.BruteForce;
import lightning.render.trace.Geometry;
import lightning.render.trace.HitRows;
import lightning.render.trace.MaterialTable;
import lightning.render.trace.SurfacePoint;
import lightning.render.trace.tree.ShadowRayTarget;

/** Reference results for {@link RowKernels}, row by row with {@link LightingEquation}. */
public final class KernelReferenceRows {
    private final HitRows rows;
    private final Geometry geometry;

    public KernelReferenceRows(HitRows rows, Geometry geometry) {
        this.rows = rows;
        this.geometry = geometry;
    }

    /** @throws IllegalStateException if a kernel disagrees */
    public void require(RowKernels kernels) {
        reshade(kernels.spot().source(), kernels.reshade());
        attenuation(kernels.spot().source(), kernels.attenuation());
        compose(kernels, kernels.composed());
        double[] powers = kernels.power();
        RatioRows scaled = kernels.ratioScaling();
        float[][] before = kernels.contributions().diffuse;
        for (int i = 0; i < rows.count; i++) {
            KernelAgreement.requireEqual(powers[i] == kernels.power(i), "power", i);
            KernelAgreement.requireEqual(scaled.diffuse[0][i], before[0][i] * kernels.intensityRatio(), "scaled row", i);
        }
    }

    private LightingEquation surfacePoint(LightSource source, int i) {
        LightingEquation equation = new LightingEquation(source);
        equation.moveTo(rows.px[i], rows.py[i], rows.pz[i], rows.nx[i], rows.ny[i], rows.nz[i]);
        return equation;
    }

    private void attenuation(LightSource source, float[] falloff) {
        for (int i = 0; i < rows.count; i++) {
            KernelAgreement.requireEqual(falloff[i], surfacePoint(source, i).falloff(), "falloff", i);
        }
    }

    private void reshade(LightSource source, LightRows layer) {
        ShadowRayTarget end = geometry.shadowRayTarget(source.position());
        for (int r = 0; r < rows.runCount; r++) {
            int material = rows.runMaterial[r];
            for (int i = rows.runStart(r); i < rows.runEnd[r]; i++) {
                LightingEquation equation = surfacePoint(source, i);
                float cosine = equation.cosine(rows.nx[i], rows.ny[i], rows.nz[i]);
                Vec3 point = new Vec3(rows.px[i], rows.py[i], rows.pz[i]);
                int state = !(cosine > 0) ? LightRows.FACING_AWAY
                        : !equation.insideCone() ? LightRows.OUTSIDE_CONE
                        : BruteForce.isBlocked(geometry, point, end) ? LightRows.SHADOWED
                        : LightRows.LIT;
                KernelAgreement.requireEqual(layer.state(i) == state, "state of row", i);
                KernelAgreement.requireEqual(layer.cosine[i], state == LightRows.LIT ? cosine : 0, "cosine of row", i);
                if (state == LightRows.LIT && layer.specular != null && geometry.materials().isSpecular(material)) {
                    KernelAgreement.requireEqual(layer.specular[i], equation.specular(rows.nx[i], rows.ny[i], rows.nz[i], rows.vx[i],
                            rows.vy[i], rows.vz[i], geometry.materials().shininess(material)), "specular term of row", i);
                }
            }
        }
    }

    private void compose(RowKernels kernels, float[][] composed) {
        for (int r = 0; r < rows.runCount; r++) {
            for (int i = rows.runStart(r); i < rows.runEnd[r]; i++) {
                SurfaceFactors factors = factors(rows.runMaterial[r], i);
                for (int c = 0; c < 3; c++) {
                    KernelAgreement.requireEqual(composed[c][rows.parent[i]], color(kernels, rows.runMaterial[r], factors, i, c),
                            "color of row", i);
                }
            }
        }
    }

    private SurfaceFactors factors(int material, int i) {
        MaterialTable m = geometry.materials();
        float[] texel = !m.isTextured(material) ? new float[] {1, 1, 1}
                : new float[] {rows.texelRed[i], rows.texelGreen[i], rows.texelBlue[i]};
        float[] kd = new float[3];
        float[] ks = new float[3];
        for (int c = 0; c < 3; c++) {
            kd[c] = m.diffuse(material, c) * texel[c];
            ks[c] = m.specular(material, c);
        }
        return new SurfaceFactors(new SurfacePoint(0, material, rows.px[i], rows.py[i], rows.pz[i], rows.nx[i], rows.ny[i], rows.nz[i],
                rows.vx[i], rows.vy[i], rows.vz[i], kd, ks, 0, texel, Map.of(), null), m.material(material));
    }

    private float color(RowKernels kernels, int material, SurfaceFactors factors, int i, int c) {
        FilmParts parts = kernels.parts();
        WeightedLight[] lights = parts.lights();
        float[] diffuse = new float[lights.length];
        float[] specular = new float[lights.length];
        for (int l = 0; l < lights.length; l++) {
            LightRows layer = (LightRows) kernels.layers()[l];
            if (layer.litCount > 0) {
                float falloff = layer.falloff == null ? 1 : layer.falloff[i];
                diffuse[l] = LightingEquation.contribution(lights[l].diffuse().channel(c), layer.cosine[i], falloff, 1);
                specular[l] = layer.specular == null ? 0
                        : LightingEquation.contribution(lights[l].specular().channel(c), layer.specular[i], falloff, 1);
            }
        }
        MaterialTable m = geometry.materials();
        float[] terms = new float[parts.count()];
        for (int part = 0; part < terms.length; part++) {
            FilmPart its = parts.get(part);
            float emitted = switch (its.kind()) {
                case AMBIENCE -> m.ambient(material, c);
                case REST -> m.ownGlow(material, c);
                case LIGHT, ENVIRONMENT_LIGHT, ENVIRONMENT_IMAGE -> 0;
            };
            float film = factors.lit(c, LightingEquation.sum(diffuse, its.from(), its.to()),
                    LightingEquation.sum(specular, its.from(), its.to()), 0);
            film += factors.mirrored(c, kernels.mirrored()[c][i]);
            terms[part] = its.weight().channel(c) * (film + factors.emitted(c, emitted));
        }
        return LightingEquation.sum(terms, 0, terms.length);
    }
}
