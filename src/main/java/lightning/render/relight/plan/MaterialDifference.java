package lightning.render.relight.plan;

import lightning.render.trace.MaterialSet;
import lightning.render.trace.MaterialTable;
import lightning.scene.Material;
import lightning.scene.MaterialAttribute;
import lightning.scene.MaterialTerm;

/** What differs between the materials that a level's rows show and those wanted, in the terms that decide the update. */
record MaterialDifference(MaterialTable before, MaterialTable after) {

    static MaterialUpdate between(MaterialTable before, MaterialTable target) {
        if (before == target) {
            return MaterialUpdate.none(target);
        }
        var difference = new MaterialDifference(before, target);
        // What shapes have that came since is in no row.
        int count = before.count();
        return new MaterialUpdate(target, MaterialSet.of(count, difference::changesColor),
                MaterialSet.of(count, difference::changesSpecular),
                MaterialSet.of(count, difference::changesTexture), MaterialSet.of(count, difference::changesMirroring));
    }

    private boolean changesColor(int m) {
        return differs(MaterialTerm.COLOR, m) || changesModel(m) || changesTexture(m);
    }

    private boolean changesSpecular(int m) {
        return changesModel(m) || before.isSpecular(m) != after.isSpecular(m) || after.isSpecular(m) && differs(MaterialTerm.HIGHLIGHT, m);
    }

    private boolean changesModel(int m) {
        return differs(MaterialTerm.MODEL, m);
    }

    private boolean changesTexture(int m) {
        // Shapes with colors of their own may have come to a material, or left it, without being seen here.
        return differs(MaterialTerm.TEXEL, m) || before.isTextured(m) != after.isTextured(m);
    }

    private boolean differs(MaterialTerm term, int m) {
        Material a = before.material(m);
        Material b = after.material(m);
        return a != b && MaterialAttribute.ALL.stream().anyMatch(attribute -> attribute.term() == term && !attribute.isEquivalent(a, b));
    }

    private boolean changesMirroring(int m) {
        return before.isReflective(m) != after.isReflective(m);
    }
}
