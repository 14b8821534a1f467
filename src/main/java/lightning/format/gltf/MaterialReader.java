package lightning.format.gltf;

import java.util.List;
import java.util.OptionalInt;
import lightning.base.math.Rgb;
import lightning.format.mesh.MeshException;
import lightning.format.mesh.Notes;

/** Reads what a glTF file says of its materials. */
final class MaterialReader {
    private static final int REPEAT = 10497;
    private static final int NEAREST = 9728;
    private static final double HALF = 0.5;

    private final GltfFile file;
    private final Notes notes;

    /** @param notes hears what is left out */
    MaterialReader(GltfFile file, Notes notes) {
        this.file = file;
        this.notes = notes;
    }

    GltfMaterial material(Json material) throws MeshException {
        Json look = material.get("pbrMetallicRoughness");
        Json extensions = material.get("extensions");
        notes.add("occlusionTexture of materials", material.get("occlusionTexture").isThere() ? 1 : 0);
        String alpha = material.get("alphaMode").text().orElse("OPAQUE");
        double factor = look.get("baseColorFactor").numbers(1, 1, 1, 1)[3];
        double there = alpha.equals("BLEND") ? factor : 1;
        boolean fades = alpha.equals("BLEND") && there == 1;
        double cutoff = alpha.equals("MASK") ? material.get("alphaCutoff").number(HALF) : fades ? HALF : 0;
        double[] emission = material.get("emissiveFactor").numbers(0, 0, 0);
        double strength = extensions.get("KHR_materials_emissive_strength").get("emissiveStrength").number(1);
        Json normals = material.get("normalTexture");
        Json base = look.get("baseColorTexture");
        boolean apart = base.isThere() && normals.isThere() && !TextureCoordinates.areAlike(base, normals);
        notes.add("normalTexture of materials placed otherwise than their baseColorTexture, as that here", apart ? 1 : 0);
        Json glossy = extensions.get("KHR_materials_pbrSpecularGlossiness");
        Surface surface = glossy.isThere() && !look.isThere() ? glossy(glossy) : metallic(look, extensions);
        return new GltfMaterial(material.get("name").text().orElse(""), surface.base, surface.metallic, surface.roughness,
                surface.reflection, surface.grazing, new Rgb(emission[0], emission[1], emission[2]).times(strength),
                glow(material.get("emissiveTexture")),
                extensions.get("KHR_materials_unlit").isThere(), surface.image, surface.picture, image(normals),
                normals.get("scale").number(1), there, glass(extensions), cutoff, factor, fades);
    }

    private OptionalInt glow(Json texture) throws MeshException {
        return texture.isThere() ? OptionalInt.of(source(texture)) : OptionalInt.empty();
    }

    /** KHR_materials_ior. */
    private static double ior(Json extensions) throws MeshException {
        return extensions.get("KHR_materials_ior").get("ior").number(1.5);
    }

    /** KHR_materials_transmission with KHR_materials_ior and KHR_materials_volume. */
    private GltfMaterial.Glass glass(Json extensions) throws MeshException {
        Json transmission = extensions.get("KHR_materials_transmission");
        Json volume = extensions.get("KHR_materials_volume");
        notes.add("transmissionTexture of materials", transmission.get("transmissionTexture").isThere() ? 1 : 0);
        notes.add("thicknessTexture of materials", volume.get("thicknessTexture").isThere() ? 1 : 0);
        double[] tint = volume.get("attenuationColor").numbers(1, 1, 1);
        return new GltfMaterial.Glass(transmission.get("transmissionFactor").number(0),
                ior(extensions), volume.get("thicknessFactor").number(0) == 0,
                new Rgb(tint[0], tint[1], tint[2]), volume.get("attenuationDistance").number(Double.POSITIVE_INFINITY));
    }

    /** How a material answers light, as {@link GltfMaterial} has it. */
    private record Surface(Rgb base, int image, double metallic, double roughness, int picture, Rgb reflection, double grazing) {}

    /** Appendix B of glTF 2.0; KHR_materials_ior; KHR_materials_specular, which caps what is tinted and then weakens all of it. */
    private Surface metallic(Json look, Json extensions) throws MeshException {
        double[] base = look.get("baseColorFactor").numbers(1, 1, 1, 1);
        double ior = ior(extensions);
        Json specular = extensions.get("KHR_materials_specular");
        for (String picture : List.of("specularTexture", "specularColorTexture")) {
            notes.add(picture + " of materials", specular.get(picture).isThere() ? 1 : 0);
        }
        double[] tint = specular.get("specularColorFactor").numbers(1, 1, 1);
        double weight = specular.get("specularFactor").number(1);
        double head = (ior - 1) * (ior - 1) / ((ior + 1) * (ior + 1));
        return new Surface(new Rgb(base[0], base[1], base[2]), image(look.get("baseColorTexture")),
                look.get("metallicFactor").number(1), look.get("roughnessFactor").number(1),
                source(look.get("metallicRoughnessTexture")), new Rgb(Math.min(head * tint[0], 1) * weight,
                        Math.min(head * tint[1], 1) * weight, Math.min(head * tint[2], 1) * weight),
                weight);
    }

    /** The model of files before the metallic one, of which nothing is a metal; that it was used is told as an extension. */
    private Surface glossy(Json look) throws MeshException {
        double[] diffuse = look.get("diffuseFactor").numbers(1, 1, 1, 1);
        double[] specular = look.get("specularFactor").numbers(1, 1, 1);
        boolean pictured = look.get("specularGlossinessTexture").isThere();
        notes.add("specularGlossinessTexture of materials", pictured ? 1 : 0);
        // What such a picture multiplies tells nothing by itself: most say 1.
        return new Surface(new Rgb(diffuse[0], diffuse[1], diffuse[2]), image(look.get("diffuseTexture")), 0,
                pictured ? 0.5 : 1 - look.get("glossinessFactor").number(1), -1,
                pictured ? Rgb.grey(0.04) : new Rgb(specular[0], specular[1], specular[2]), 1);
    }

    private int image(Json texture) throws MeshException {
        if (texture.isThere()) {
            sampler(texture.get("index").in(file.array("textures")).get("sampler"));
        }
        return source(texture);
    }

    /** The number of a texture's image; −1 for none. */
    private int source(Json texture) throws MeshException {
        if (!texture.isThere()) {
            return -1;
        }
        Json source = texture.get("index").in(file.array("textures")).get("source");
        if (!source.isThere()) {
            notes.add("textures in formats of extensions");
            return -1;
        }
        return source.index(file.array("images"));
    }

    /** A texture here repeats and is smooth between its pixels. */
    private void sampler(Json index) throws MeshException {
        if (index.isThere()) {
            Json sampler = index.in(file.array("samplers"));
            boolean repeats = true;
            for (String wrap : List.of("wrapS", "wrapT")) {
                repeats &= sampler.get(wrap).whole(0, Integer.MAX_VALUE, REPEAT) == REPEAT;
            }
            notes.add("textures that end or turn back at their edges, repeated here", repeats ? 0 : 1);
            notes.add("textures with hard pixels, smooth here", sampler.get("magFilter").whole(0, Integer.MAX_VALUE, 0) == NEAREST ? 1 : 0);
        }
    }
}
