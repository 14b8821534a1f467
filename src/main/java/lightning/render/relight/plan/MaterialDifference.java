package lightning.render.relight.plan;

import lightning.render.trace.MaterialSet;
import lightning.render.trace.MaterialTable;
import lightning.scene.material.Material;
import lightning.scene.material.MaterialAttribute;
import lightning.scene.material.MaterialTerm;

/** Difference between the materials of a level's rows and the target materials, in the terms that decide the update. */
record MaterialDifference(MaterialTable before, MaterialTable after) {

    static MaterialUpdate between(MaterialTable before, MaterialTable target) {
        if (before == target) {
            return MaterialUpdate.none(target);
        }
        var difference = new MaterialDifference(before, target);
        // Materials of shapes added since are in no row.
        int count = before.count();
        return new MaterialUpdate(target, MaterialSet.of(count, difference::changesColor),
                MaterialSet.of(count, difference::changesSpecular),
                MaterialSet.of(count, difference::changesTexture), MaterialSet.of(count, difference::changesMirroring));
    }

    private boolean changesColor(int m) {
        return differs(MaterialTerm.COLOR, m) || after.material(m).isPrincipled() && differs(MaterialTerm.HIGHLIGHT, m) || changesBulb(m)
                || changesModel(m) || changesTexture(m);
    }

    private boolean changesBulb(int m) {
        return !before.material(m).bulb().light().equals(after.material(m).bulb().light())
                || !before.material(m).bulb().unit().equals(after.material(m).bulb().unit());
    }

    private boolean changesSpecular(int m) {
        return changesModel(m) || before.material(m).isPrincipled() != after.material(m).isPrincipled()
                || before.isSpecular(m) != after.isSpecular(m)
                || before.material(m).isAnisotropic() != after.material(m).isAnisotropic()
                || before.material(m).f0UnderSheen() != after.material(m).f0UnderSheen()
                || after.isSpecular(m) && (differs(MaterialTerm.HIGHLIGHT, m) || differs(MaterialTerm.HIGHLIGHT_TEXEL, m));
    }

    private boolean changesModel(int m) {
        return differs(MaterialTerm.MODEL, m);
    }

    private boolean changesTexture(int m) {
        // Shapes with their own colors may have joined or left a material without a visible change here.
        return differs(MaterialTerm.TEXEL, m) || differs(MaterialTerm.HIGHLIGHT_TEXEL, m) || !before.texels(m).equals(after.texels(m));
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
