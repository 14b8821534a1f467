package lightning.gltf;

import java.util.List;
import lightning.math.Rgb;
import lightning.mesh.MeshException;
import lightning.mesh.Notes;

/** Reads what a glTF file says of its materials. */
final class MaterialReader {
    private static final int REPEAT = 10497;
    private static final int NEAREST = 9728;

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
        double[] base = look.get("baseColorFactor").numbers(1, 1, 1, 1);
        double[] emission = material.get("emissiveFactor").numbers(0, 0, 0);
        double strength = extensions.get("KHR_materials_emissive_strength").get("emissiveStrength").number(1);
        double ior = extensions.get("KHR_materials_ior").get("ior").number(1.5);
        Json specular = extensions.get("KHR_materials_specular");
        double[] tint = specular.get("specularColorFactor").numbers(1, 1, 1);
        double head = Math.pow((ior - 1) / (ior + 1), 2) * specular.get("specularFactor").number(1);
        for (String picture : List.of("occlusionTexture", "emissiveTexture")) {
            notes.add(picture + " of materials", material.get(picture).isThere() ? 1 : 0);
        }
        for (String picture : List.of("specularTexture", "specularColorTexture")) {
            notes.add(picture + " of materials", specular.get(picture).isThere() ? 1 : 0);
        }
        Json normals = material.get("normalTexture");
        notes.add("metallicRoughnessTexture of materials", look.get("metallicRoughnessTexture").isThere() ? 1 : 0);
        notes.add("transparent materials", material.get("alphaMode").text().orElse("OPAQUE").equals("OPAQUE") ? 0 : 1);
        return new GltfMaterial(material.get("name").text().orElse(""), new Rgb(base[0], base[1], base[2]),
                look.get("metallicFactor").number(1),
                look.get("roughnessFactor").number(1), new Rgb(head * tint[0], head * tint[1], head * tint[2]),
                new Rgb(emission[0], emission[1], emission[2]).times(strength), extensions.get("KHR_materials_unlit").isThere(),
                image(look.get("baseColorTexture")), image(normals), normals.get("scale").number(1));
    }

    private int image(Json texture) throws MeshException {
        if (!texture.isThere()) {
            return -1;
        }
        Json named = texture.get("index").in(file.array("textures"));
        sampler(named.get("sampler"));
        Json source = named.get("source");
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
