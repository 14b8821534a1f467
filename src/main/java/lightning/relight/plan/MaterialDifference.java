package lightning.relight.plan;

import java.util.Optional;
import lightning.scene.TextureMap;
import lightning.trace.MaterialSet;
import lightning.trace.MaterialTable;

/** What differs between the materials that a level's rows show and those wanted, in the terms that decide the update. */
record MaterialDifference(MaterialTable before, MaterialTable wanted) {

    static MaterialUpdate between(MaterialTable before, MaterialTable wanted) {
        if (before == wanted) {
            return MaterialUpdate.none(wanted);
        }
        var difference = new MaterialDifference(before, wanted);
        int count = wanted.count();
        return new MaterialUpdate(wanted, MaterialSet.of(count, difference::recolors), MaterialSet.of(count, difference::specular),
                MaterialSet.of(count, difference::texture), MaterialSet.of(count, difference::mirrors));
    }

    private boolean recolors(int m) {
        boolean colors = texture(m);
        for (int c = 0; c < 3; c++) {
            colors |= before.ambient(m, c) != wanted.ambient(m, c) || before.diffuse(m, c) != wanted.diffuse(m, c)
                    || before.specular(m, c) != wanted.specular(m, c) || before.reflective(m, c) != wanted.reflective(m, c);
        }
        return colors;
    }

    private boolean specular(int m) {
        return before.isSpecular(m) != wanted.isSpecular(m)
                || wanted.isSpecular(m) && before.shininess(m) != wanted.shininess(m);
    }

    private boolean texture(int m) {
        Optional<TextureMap> a = before.material(m).texture();
        Optional<TextureMap> b = wanted.material(m).texture();
        return a.isPresent() != b.isPresent() || a.isPresent() && !sameTexels(a.get(), b.get());
    }

    /** Another file name alone shows nothing. */
    private static boolean sameTexels(TextureMap a, TextureMap b) {
        return a.repeatU() == b.repeatU() && a.repeatV() == b.repeatV() && a.image().equals(b.image());
    }

    private boolean mirrors(int m) {
        return before.isReflective(m) != wanted.isReflective(m);
    }
}
