package lightning.render.shading.reference;

import java.util.Arrays;
import java.util.BitSet;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.function.Function;
import lightning.base.work.Progress;
import lightning.base.work.WorkerPool;
import lightning.render.gather.GatherStructure;
import lightning.render.gather.RowWeigher;
import lightning.render.gather.build.GatherBuilder;
import lightning.render.gather.ray.FilmLight;
import lightning.render.shading.Bsdf;
import lightning.render.shading.FilmPart;
import lightning.render.shading.FilmParts;
import lightning.render.shading.IndirectLight;
import lightning.render.shading.IndirectSolver;
import lightning.render.shading.PrincipledRow;
import lightning.render.shading.ShadingMaterial;
import lightning.render.shading.StoredFilms;
import lightning.render.trace.Geometry;
import lightning.render.trace.HitRows;
import lightning.render.trace.HitRows.ColumnGroup;
import lightning.render.trace.MappedSurface;
import lightning.render.trace.MaterialTable;
import lightning.render.trace.PrincipledColors;
import lightning.render.trace.SurfacePoint;
import lightning.scene.GatherSettings;
import lightning.scene.Scene;
import lightning.scene.material.Material;

/**
 * Gathered light and blurred reflections of a scene for {@link ReferenceTracer}. Paths are those of a first build; the light that they carry is
 * computed point by point. So it is an oracle of edits and of light, but not of paths.
 */
final class ReferenceReflections {
    private final IndirectLight light;
    private final RowWeigher weigher;

    /**
     * @param directLight returns the lights' diffuse sum at a surface: red, green, blue of each film
     * @param shownLight  returns the lights' diffuse and specular light that films show of a surface: red, green, blue of each
     */
    ReferenceReflections(FilmParts parts, Geometry geometry, GatherSettings settings, Function<SurfacePoint, float[]> directLight,
            Function<SurfacePoint, float[]> shownLight) {
        Scene scene = parts.scene();
        WorkerPool workers = new WorkerPool(1);
        GatherStructure structure = new GatherBuilder(geometry, scene, settings, workers,
                _ -> new ReferenceRays(geometry), 1L << 30, Progress.NONE).build();
        int count = structure.surfelCount();
        int channels = 3 * parts.count();
        float[][] direct = new float[channels][count];
        float[][] albedo = new float[3][count];
        float[][] glow = new float[channels][count];
        float[][] seen = new float[channels][count];
        HitRows[] blocks = structure.surfels();
        MaterialTable materials = geometry.materials();
        for (int block = 0; block < blocks.length; block++) {
            HitRows rows = blocks[block];
            for (int row = 0; row < rows.count; row++) {
                int surfel = structure.numbers(block)[rows.parent[row]];
                int material = rows.material(row);
                SurfacePoint point = point(materials, rows, row, material);
                float[] lit = directLight.apply(point);
                float[] shown = shownLight.apply(point);
                for (int channel = 0; channel < channels; channel++) {
                    int c = channel % 3;
                    float texel = materials.isTextured(material) ? rows.texel(c)[row] : 1;
                    boolean isMapped = materials.texels(material).has(ColumnGroup.GLOW_TEXEL);
                    float map = isMapped ? rows.texel(ColumnGroup.GLOW_TEXEL, c)[row] : 1;
                    float left = 1 - materials.reflective(material, c);
                    direct[channel][surfel] = lit[channel];
                    albedo[c][surfel] = albedo(materials, rows, row, c, texel, left);
                    FilmPart part = parts.get(channel / 3);
                    float emitted = switch (part.kind()) {
                        case AMBIENCE -> left * materials.ambient(material, c);
                        case REST -> left * materials.ownGlow(material, c) * map;
                        case LIGHT -> materials.material(material).bulb().light().equals(scene.lights().get(part.index()).name())
                                ? left * materials.bulbGlow(material, c) * map : 0;
                        case ENVIRONMENT_LIGHT, ENVIRONMENT_IMAGE -> 0;
                    };
                    glow[channel][surfel] = part.kind() == FilmPart.Kind.REST ? emitted : 0;
                    seen[channel][surfel] = emitted + shown[channel];
                }
            }
        }
        float[][] objects = structure.glow().shapes().glow(materials);
        float[][][] films = new float[parts.count()][][];
        BitSet known = new BitSet();
        for (int part = 0; part < films.length; part++) {
            known.set(part);
            // Each film alone, as the oracle of films side by side.
            var source = new IndirectSolver.Source(of(direct, part), of(glow, part),
                    parts.get(part).kind() == FilmPart.Kind.REST ? objects : null, of(seen, part), parts.background(part));
            films[part] = new IndirectSolver(structure, List.of(source), albedo, ReferenceReflections::weightedSum, workers, Progress.NONE)
                    .solve()[0];
        }
        light = new IndirectLight(structure, new StoredFilms(films, known), films);
        weigher = new RowWeigher(structure);
    }

    /** Sums as {@link lightning.render.gather.ray.FilmKernel}, one float after the other. */
    private static void weightedSum(FilmLight light, int[] number, float[] weight, int count, float[] to) {
        for (int k = 0; k < light.stride(); k++) {
            to[k] = 0;
            for (int n = 0; n < count; n++) {
                to[k] += weight[n] * light.values()[light.at(number[n], 0) + k];
            }
        }
    }

    private static float[][] of(float[][] channels, int part) {
        return Arrays.copyOfRange(channels, 3 * part, 3 * part + 3);
    }

    /** Returns the surface of a surfel's row, with the mean colors of its images. */
    private static SurfacePoint point(MaterialTable materials, HitRows rows, int row, int material) {
        Map<ColumnGroup, float[]> maps = new EnumMap<>(ColumnGroup.class);
        for (ColumnGroup group : ColumnGroup.values()) {
            if ((ColumnGroup.TEXELS.contains(group) && group != ColumnGroup.TEXEL || group == ColumnGroup.TANGENT)
                    && materials.texels(material).has(group)) {
                float[][] columns = rows.texels(group);
                float[] value = new float[columns.length];
                for (int c = 0; c < value.length; c++) {
                    value[c] = columns[c][row];
                }
                maps.put(group, value);
            }
        }
        float[] texel = {1, 1, 1};
        float[] diffuse = new float[3];
        float[] specular = new float[3];
        Material look = materials.material(material);
        var mapped = new MappedSurface();
        if (look.isPrincipled()) {
            mapped.moveTo(look, maps);
        }
        for (int c = 0; c < 3; c++) {
            texel[c] = materials.isTextured(material) ? rows.texel(c)[row] : 1;
            diffuse[c] = materials.diffuse(material, c) * texel[c];
            specular[c] = materials.metalF0(material, c) * texel[c] + materials.specular(material, c);
            if (look.isPrincipled() && look.surfaceMaps().changeColors()) {
                var colors = new PrincipledColors(look);
                diffuse[c] = colors.diffuse(c, mapped) * texel[c];
                specular[c] = colors.f0(c, mapped, texel[c]);
            }
        }
        return new SurfacePoint(rows.owner[row], material, rows.px[row], rows.py[row], rows.pz[row], rows.nx[row], rows.ny[row],
                rows.nz[row], rows.vx[row], rows.vy[row], rows.vz[row], diffuse, specular,
                look.isPrincipled() ? mapped.roughness() : look.roughness(), texel, maps, null);
    }

    /** Returns one channel of the share that a surfel sends back: a principled one its reflection, too. */
    private static float albedo(MaterialTable materials, HitRows rows, int row, int c, float texel, float left) {
        int m = rows.material(row);
        if (!materials.material(m).isPrincipled()) {
            return left * materials.diffuse(m, c) * texel;
        }
        PrincipledRow colors = new PrincipledRow();
        colors.start((Bsdf.Principled) Bsdf.of(materials.material(m)), ShadingMaterial.of(materials, m), rows);
        colors.moveTo(row);
        float below = 1 - hemispherical(colors.surface().largestNonmetalF0());
        return ReferenceSheen.albedo(materials.material(m), colors.surface(), c, colors.diffuse(c) * below + hemispherical(colors.f0(c)));
    }

    private static float hemispherical(float f0) {
        return f0 + (1 - f0) / 21;
    }

    /** Returns the light at a surface that the picture shows, as {@link IndirectLight#at}. */
    float[] at(SurfacePoint hit, int film) {
        return light.at(hit, weigher, film);
    }
}
