package lightning.render.relight.plan;

import lightning.render.trace.MaterialSet;
import lightning.render.trace.MaterialTable;
import lightning.scene.Material;
import lightning.scene.MaterialAttribute;
import lightning.scene.MaterialTerm;

/** What differs between the materials that a level's rows show and those wanted, in the terms that decide the update. */
record MaterialDifference(MaterialTable before, MaterialTable wanted) {

    static MaterialUpdate between(MaterialTable before, MaterialTable wanted) {
        if (before == wanted) {
            return MaterialUpdate.none(wanted);
        }
        var difference = new MaterialDifference(before, wanted);
        // What shapes have that came since is in no row.
        int count = before.count();
        return new MaterialUpdate(wanted, MaterialSet.of(count, difference::recolors), MaterialSet.of(count, difference::specular),
                MaterialSet.of(count, difference::texture), MaterialSet.of(count, difference::mirrors));
    }

    private boolean recolors(int m) {
        return differs(MaterialTerm.COLOR, m) || model(m) || texture(m);
    }

    private boolean specular(int m) {
        return model(m) || before.isSpecular(m) != wanted.isSpecular(m) || wanted.isSpecular(m) && differs(MaterialTerm.HIGHLIGHT, m);
    }

    private boolean model(int m) {
        return differs(MaterialTerm.MODEL, m);
    }

    private boolean texture(int m) {
        // Shapes with colours of their own may have come to a material, or left it, without being seen here.
        return differs(MaterialTerm.TEXEL, m) || before.isTextured(m) != wanted.isTextured(m);
    }

    private boolean differs(MaterialTerm term, int m) {
        Material a = before.material(m);
        Material b = wanted.material(m);
        return a != b && MaterialAttribute.ALL.stream().anyMatch(attribute -> attribute.term() == term && !attribute.isAlike(a, b));
    }

    private boolean mirrors(int m) {
        return before.isReflective(m) != wanted.isReflective(m);
    }
}
