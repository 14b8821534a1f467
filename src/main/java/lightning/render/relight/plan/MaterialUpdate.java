package lightning.render.relight.plan;

import java.util.ArrayList;
import java.util.List;
import lightning.render.trace.MaterialSet;
import lightning.render.trace.MaterialTable;

/**
 * What an edit of materials asks of a level's rows, from the cheapest to the dearest. A material may be in several sets.
 *
 * @param materials  as they are wanted
 * @param recolored  any colour or the texture changed: the equation is closed anew where their rows are
 * @param speculars  the shininess, roughness or model changed, or highlights came or went: terms of each light are computed anew,
 *                   without a ray
 * @param retextured the texture changed: their rows' texels are looked up anew, without a search
 * @param mirrors    reflectivity came or went: their rows begin or cease to cast mirrored rays
 */
public record MaterialUpdate(MaterialTable materials, MaterialSet recolored, MaterialSet speculars, MaterialSet retextured,
        MaterialSet mirrors) {

    /** No material is another. */
    public static MaterialUpdate none(MaterialTable materials) {
        return new MaterialUpdate(materials, MaterialSet.NONE, MaterialSet.NONE, MaterialSet.NONE, MaterialSet.NONE);
    }

    public boolean isEmpty() {
        return recolored.isEmpty() && speculars.isEmpty() && retextured.isEmpty() && mirrors.isEmpty();
    }

    /** The steps in words, one for each material. */
    List<String> steps() {
        List<String> steps = new ArrayList<>();
        for (int m = 0; m < materials.count() && !isEmpty(); m++) {
            List<String> parts = new ArrayList<>();
            if (mirrors.contains(m)) {
                parts.add(materials.isReflective(m) ? "begins to mirror" : "ceases to mirror");
            }
            if (retextured.contains(m)) {
                parts.add("texture");
            }
            if (speculars.contains(m)) {
                parts.add(materials.isSpecular(m) ? "specular term" : "no highlights");
            }
            if (parts.isEmpty() && recolored.contains(m)) {
                parts.add("colours");
            }
            if (!parts.isEmpty()) {
                steps.add(materials.material(m).name() + ": " + String.join(" + ", parts));
            }
        }
        return steps;
    }
}
