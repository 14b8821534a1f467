package lightning.format.exchange.usd;

import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.OptionalDouble;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import lightning.base.text.DecimalNumber;
import lightning.format.exchange.assembly.SceneAssembler;
import lightning.format.gltf.JsonValue;
import lightning.format.mesh.MeshException;
import lightning.scene.value.DomeRotation;

/**
 * Paths of a scene's lights and objects in the stage that it was imported from. Comments of the scene file store them, because rendering
 * does not use them.
 *
 * @param hasZUp  true if the z axis of the stage is up
 * @param shift   time in the stage of frame 0
 * @param lights  path and type of each light, by its name
 * @param domes   the dome lights that environments stand for, by their names
 * @param objects path of each shape and group, by its name
 * @param originals each light as it was imported, by its name; none of scenes that were imported by versions without them
 * @param hidden  prims above hidden lights, by their path
 * @param renamed name of each file in the stage, by its other name in the scene
 */
public record UsdPaths(boolean hasZUp, int shift, Map<String, Prim> lights, Map<String, Dome> domes,
        Map<String, String> objects,
        Map<String, UsdOriginal> originals, Map<String, String> renamed, Map<String, UsdHiddenParent> hidden) {
    private static final String UP = "usd up: ";
    private static final String SHIFT = "usd time of frame 0: ";
    private static final Pattern LIGHT = Pattern.compile("# usd light: (\\w+) (/\\S*) (.+)");
    private static final Pattern DOME = Pattern.compile("# usd dome: (\\w+) (/\\S*) (\\S+) (\\S+) (.+)");
    private static final Pattern DOME_INTENSITY = Pattern.compile("# usd dome intensity: (\\S+)");
    private static final Pattern NAMED_DOME = Pattern.compile("# usd named dome: (\\w+) (/\\S*) (\\S+) (\\S+) (\\S+) ([^<>]+?) < (.+)");
    private static final Pattern RENAMED = Pattern.compile("# wrote: [0-9a-f]{64} ([^<>]+?) < ([^<>]+)");
    private static final Pattern OBJECT = Pattern.compile("# usd prim: (/\\S*) (.+)");

    /** Prim with its type. */
    public record Prim(String type, String path) {}

    /**
     * Dome light.
     *
     * @param factor   its intensity for an intensity of 1 of the environment
     * @param rotation rotation of the environment that it has
     * @param file     file of the environment that it has
     * @param intensity intensity of the environment that it has; empty if the comments do not say
     */
    public record Dome(Prim prim, double factor, DomeRotation rotation, String file, OptionalDouble intensity) {}

    /** Adds the comment of the up axis. */
    static void addAxis(SceneAssembler assembler, boolean hasZUp) {
        assembler.addComment(UP + (hasZUp ? "Z" : "Y"));
    }

    /** Adds the comment of a moved timeline. */
    static void addShift(SceneAssembler assembler, int shift) {
        if (shift != 0) {
            assembler.addComment(SHIFT + shift);
        }
    }

    /** Adds the comment of a light, also of one in an instance. */
    static void addLight(SceneAssembler assembler, String name, JsonValue in) throws MeshException {
        if (isWritable(path(in))) {
            assembler.closingComments.add("usd light: " + in.get("type").text().orElse("") + " " + path(in) + " " + name);
        }
    }

    /** Adds the comment of a dome light. @param name of the environment that it stands for */
    static void addDome(SceneAssembler assembler, JsonValue in, double factor, DomeRotation rotation, double intensity, String file,
            String name) throws MeshException {
        if (!isPath(in)) {
            return;
        }
        String start = in.get("type").text().orElse("") + " " + path(in) + " " + factor + " " + text(rotation) + " ";
        if (name.equals(lightning.scene.Dome.OWN)) {
            assembler.closingComments.add("usd dome: " + start + file);
            assembler.closingComments.add("usd dome intensity: " + intensity);
        } else {
            assembler.closingComments.add("usd named dome: " + start + intensity + " " + file + " < " + name);
        }
    }

    /** Adds the comment of an object. */
    static void addObject(SceneAssembler assembler, String name, JsonValue in) throws MeshException {
        if (isPath(in)) {
            assembler.closingComments.add("usd prim: " + path(in) + " " + name);
        }
    }

    /** Returns whether a path can be written in a comment, and changed by a layer: not that of a part of an instance. */
    private static boolean isPath(JsonValue in) throws MeshException {
        return !in.get("proxy").bool(false) && isWritable(path(in));
    }

    static boolean isWritable(String path) {
        return path.matches("(/[\\p{L}\\p{N}_]+)+");
    }

    private static String path(JsonValue in) throws MeshException {
        return in.get("path").text().orElse("");
    }

    /** Returns what the comments of a scene file say. */
    public static UsdPaths findIn(String text) {
        Map<String, Prim> lights = new LinkedHashMap<>();
        Map<String, String> objects = new HashMap<>();
        Map<String, UsdOriginal> originals = new HashMap<>();
        Map<String, String> renamed = new HashMap<>();
        Map<String, UsdHiddenParent> hidden = new HashMap<>();
        Map<String, Dome> domes = new LinkedHashMap<>();
        boolean hasZUp = false;
        int shift = 0;
        for (String line : (Iterable<String>) text.lines().filter(s -> s.startsWith("# usd ") || s.startsWith("# wrote: "))::iterator) {
            hasZUp |= line.equals("# " + UP + "Z");
            shift = line.startsWith("# " + SHIFT) ? (int) number(line.substring(SHIFT.length() + 2)) : shift;
            Matcher light = LIGHT.matcher(line);
            Matcher object = OBJECT.matcher(line);
            Matcher environment = DOME.matcher(line);
            Matcher named = NAMED_DOME.matcher(line);
            Matcher strength = DOME_INTENSITY.matcher(line);
            Matcher file = RENAMED.matcher(line);
            if (light.matches()) {
                lights.put(light.group(3), new Prim(light.group(1), light.group(2)));
            } else if (object.matches()) {
                objects.put(object.group(2), object.group(1));
            } else if (environment.matches()) {
                domes.put(lightning.scene.Dome.OWN, new Dome(new Prim(environment.group(1), environment.group(2)),
                        number(environment.group(3)), rotation(environment.group(4)), environment.group(5), OptionalDouble.empty()));
            } else if (named.matches()) {
                domes.put(named.group(7), new Dome(new Prim(named.group(1), named.group(2)), number(named.group(3)),
                        rotation(named.group(4)), named.group(6), DecimalNumber.parse(named.group(5))));
            } else if (line.startsWith("# " + UsdOriginal.COMMENT)) {
                UsdOriginal.parse(line.substring(2)).ifPresent(original -> originals.put(original.light().name(), original));
            } else if (line.startsWith("# " + UsdHiddenParent.COMMENT)) {
                UsdHiddenParent.parse(line.substring(2)).ifPresent(parent -> hidden.put(parent.path(), parent));
            } else if (strength.matches()) {
                domes.computeIfPresent(lightning.scene.Dome.OWN, (_, its) -> new Dome(its.prim, its.factor, its.rotation, its.file,
                        DecimalNumber.parse(strength.group(1))));
            } else if (file.matches()) {
                renamed.put(file.group(1), file.group(2));
            }
        }
        return new UsdPaths(hasZUp, shift, lights, domes, objects, originals, renamed, hidden);
    }

    /** Returns whether a file of the scene is that of the import, which may have got another name since. */
    public boolean isSameFile(String imported, String now) {
        return imported.equals(now) || imported.equals(renamed.get(now));
    }

    /** Returns the angle about y, or all three if there are others. */
    private static String text(DomeRotation v) {
        return v.isUpright() ? String.valueOf(v.rotation()) : v.rotation() + "," + v.tilt() + "," + v.roll();
    }

    private static DomeRotation rotation(String text) {
        String[] angles = text.split(",", 3);
        return angles.length < 3 ? DomeRotation.of(number(angles[0]), 0, 0)
                : DomeRotation.of(number(angles[0]), number(angles[1]), number(angles[2]));
    }

    private static double number(String text) {
        return DecimalNumber.parse(text).orElse(1);
    }
}
