package lightning.jen;

import java.util.List;
import java.util.Map;
import java.util.function.Function;
import lightning.math.Rgb;
import lightning.math.Vec3;
import lightning.scene.Texture;

/**
 * All values of one block by property name, written or by default, in the types of the scene.
 *
 * @param textures finds the decoded picture of a file that the block names
 */
record Values(Map<String, Value> all, Function<String, Texture> textures) {

    boolean has(String property) {
        return !(all.get(property) instanceof Value.Absent);
    }

    double number(String property) {
        return numbers(property).get(0);
    }

    int whole(String property, int index) {
        return numbers(property).get(index).intValue();
    }

    double number(String property, int index) {
        return numbers(property).get(index);
    }

    Vec3 vector(String property) {
        List<Double> n = numbers(property);
        return new Vec3(n.get(0), n.get(1), n.get(2));
    }

    Rgb color(String property) {
        List<Double> n = numbers(property);
        return new Rgb(n.get(0), n.get(1), n.get(2));
    }

    String word(String property) {
        return ((Value.Word) all.get(property)).text();
    }

    String name(String property) {
        return ((Value.Name) all.get(property)).name();
    }

    boolean yes(String property) {
        return word(property).equals("yes");
    }

    String file(String property) {
        return ((Value.Quoted) all.get(property)).file();
    }

    private List<Double> numbers(String property) {
        return ((Value.Numbers) all.get(property)).all();
    }
}
