package lightning.format.gltf;

import static java.util.Objects.requireNonNull;

import java.io.IOException;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.HashMap;
import java.util.IdentityHashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import lightning.base.math.Rgb;
import lightning.base.math.Transform;
import lightning.format.gltf.AnimatedProperty.Kind;
import lightning.format.mesh.ConversionNotes;
import lightning.format.mesh.MeshException;

/** First animation of a glTF file: transforms of nodes, and values of lights and cameras (KHR_animation_pointer), at each frame. */
public final class GltfAnimation {
    /** Maximum number of frames. */
    public static final int MAX_FRAMES = 10_000;
    private static final double MAX_FRAME = 1e9;
    private static final double[] NO_ROTATION = {0, 0, 0, 1};

    private final Map<AnimatedProperty, KeyedValues> keys = new LinkedHashMap<>();
    private final Map<Integer, Rest> rests = new HashMap<>();
    private final double rate;
    private final int first;
    private final int last;
    private int morphs;

    /** Values that a node has without its animation. */
    private record Rest(double[] translation, double[] rotation, double[] scale) {}

    /** Keys as the file has them. */
    private record Channel(AnimatedProperty property, float[] times, float[] values, KeyedValues.Form form) {}

    /** Reader of the samplers of an animation. */
    private static final class Samplers {
        private final GltfFile file;
        private final JsonValue samplers;
        private final AccessorReader accessors;
        private final ExpansionLimit limit;
        private final Map<String, float[]> cachedValues = new HashMap<>();
        private final Set<float[]> checkedTimes = Collections.newSetFromMap(new IdentityHashMap<>());
        private long bytes;

        Samplers(GltfFile file, JsonValue samplers) throws IOException, MeshException {
            this.file = file;
            this.samplers = samplers;
            accessors = new AccessorReader(file);
            limit = new ExpansionLimit(file);
        }

        Channel channel(AnimatedProperty property, JsonValue index) throws IOException, MeshException {
            JsonValue sampler = index.resolve(samplers);
            float[] times = times(sampler.get("input"));
            KeyedValues.Form form = KeyedValues.Form.parse(sampler.get("interpolation"));
            float[] values = values(sampler.get("output"), property.kind().components());
            if (values.length != times.length * form.valuesPerKey() * property.kind().components()) {
                throw sampler.get("output").problem("must have " + form.valuesPerKey() + " values for each of " + times.length + " times");
            }
            return new Channel(property, times, values, form);
        }

        private float[] times(JsonValue accessor) throws IOException, MeshException {
            float[] times = values(accessor, 1);
            if (checkedTimes.add(times)) {
                for (int i = 0; i < times.length; i++) {
                    if (!(times[i] >= (i == 0 ? 0 : times[i - 1]))) {
                        throw accessor.problem("must be times from 0 in order");
                    }
                }
            }
            return times;
        }

        /** Returns the numbers of an accessor, read once. */
        private float[] values(JsonValue accessor, int components) throws IOException, MeshException {
            String key = accessor.index(file.array("accessors")) + " " + components;
            float[] known = cachedValues.get(key);
            if (known == null) {
                // Times become frames of double precision.
                bytes += 12L * components * accessors.count(accessor);
                limit.checkBytes(bytes, accessor);
                known = accessors.floats(accessor, components);
                for (float value : known) {
                    if (!Float.isFinite(value)) {
                        throw accessor.problem("must have finite numbers");
                    }
                }
                cachedValues.put(key, known);
            }
            return known;
        }
    }

    private GltfAnimation(GltfFile file, ConversionNotes notes) throws IOException, MeshException {
        List<Channel> channels = channels(file, notes);
        Map<float[], double[]> frames = new IdentityHashMap<>();
        channels.forEach(channel -> frames.put(channel.times, new double[0]));
        var clock = AnimationClock.of(frames.keySet());
        rate = clock.rate();
        frames.replaceAll((times, _) -> clock.frames(times));
        for (Channel channel : channels) {
            Kind kind = channel.property.kind();
            keys.put(channel.property,
                    new KeyedValues(requireNonNull(frames.get(channel.times)), channel.values, kind.components(), channel.form, rate,
                            kind == Kind.ROTATION));
        }
        double start = frames.values().stream().mapToDouble(f -> Math.floor(f[0])).min().orElse(0);
        double end = frames.values().stream().mapToDouble(f -> Math.ceil(f[f.length - 1])).max().orElse(0);
        if (end > MAX_FRAME) {
            throw file.array("animations").problem("must end before frame " + (long) MAX_FRAME);
        }
        first = (int) start;
        last = (int) Math.min(end, start + MAX_FRAMES - 1);
        notes.add("frames after the first " + MAX_FRAMES, (int) end - last);
    }

    /**
     * Reads the first animation; empty if there is none that can be read.
     *
     * @param notes receives what is left out
     */
    public static Optional<GltfAnimation> read(GltfFile file, ConversionNotes notes) throws IOException, MeshException {
        if (file.array("animations").size() == 0) {
            return Optional.empty();
        }
        notes.add("animations after the first", file.array("animations").size() - 1);
        try {
            return Optional.of(new GltfAnimation(file, notes));
        } catch (MeshException e) {
            // The scene can be shown without it.
            notes.add("animations that cannot be read");
            return Optional.empty();
        }
    }

    private List<Channel> channels(GltfFile file, ConversionNotes notes) throws IOException, MeshException {
        JsonValue animation = file.array("animations").element(0);
        var samplers = new Samplers(file, animation.get("samplers"));
        List<Channel> channels = new ArrayList<>();
        int others = 0;
        for (int i = 0; i < animation.get("channels").size(); i++) {
            JsonValue channel = animation.get("channels").element(i);
            Optional<AnimatedProperty> property = AnimatedProperty.of(file, channel.get("target"));
            if (property.isEmpty()) {
                others++;
            } else if (property.get().kind() == Kind.WEIGHTS) {
                morphs++;
            } else if (addRest(file, property.get(), notes)) {
                channels.add(samplers.channel(property.get(), channel.get("sampler")));
            }
        }
        notes.add("animated properties of a kind that is not imported", others);
        return channels;
    }

    /** Reads the values that a property's node has without animation; returns whether the property can be animated. */
    private boolean addRest(GltfFile file, AnimatedProperty property, ConversionNotes notes) throws MeshException {
        if (property.kind() != Kind.TRANSLATION && property.kind() != Kind.ROTATION && property.kind() != Kind.SCALE) {
            return true;
        }
        JsonValue node = file.array("nodes").element(property.index());
        if (node.get("matrix").isPresent()) {
            notes.add("animated properties of nodes with a matrix");
            return false;
        }
        rests.put(property.index(), new Rest(node.get("translation").numbers(0, 0, 0), node.get("rotation").numbers(NO_ROTATION),
                node.get("scale").numbers(1, 1, 1)));
        return true;
    }

    /** Returns the first frame. */
    public int first() {
        return first;
    }

    /** Returns the last frame, less than {@link #MAX_FRAMES} after the first. */
    public int last() {
        return last;
    }

    /** Returns the number of frames per second. */
    public double rate() {
        return rate;
    }

    /** Returns the number of meshes whose morph targets move. */
    public int morphCount() {
        return morphs;
    }

    /** Returns whether a node itself moves. */
    public boolean moves(GltfNode node) {
        return rests.containsKey(node.index());
    }

    /** Returns whether a light has keys of its own. */
    public boolean changesLight(int light) {
        return keys.containsKey(new AnimatedProperty(Kind.INTENSITY, light)) || keys.containsKey(new AnimatedProperty(Kind.COLOR, light));
    }

    /** Returns whether a camera has keys of its own. */
    public boolean changesCamera(int camera) {
        return keys.containsKey(new AnimatedProperty(Kind.FIELD_OF_VIEW, camera));
    }

    /** Returns a node's transform to its parent's space at a frame. */
    public Transform local(GltfNode node, int frame) {
        Rest rest = rests.get(node.index());
        if (rest == null) {
            return node.local();
        }
        double[] rotation = at(Kind.ROTATION, node.index(), rest.rotation, frame);
        return GltfScene.transform(at(Kind.TRANSLATION, node.index(), rest.translation, frame),
                Arrays.stream(rotation).allMatch(v -> v == 0) ? NO_ROTATION : rotation,
                at(Kind.SCALE, node.index(), rest.scale, frame));
    }

    /** Returns a light's intensity at a frame. */
    public double intensity(GltfLight light, int frame) {
        return at(Kind.INTENSITY, light.index(), new double[] {light.intensity()}, frame)[0];
    }

    /** Returns a light's color at a frame. */
    public Rgb color(GltfLight light, int frame) {
        double[] color = at(Kind.COLOR, light.index(), new double[] {light.color().r(), light.color().g(), light.color().b()}, frame);
        return new Rgb(color[0], color[1], color[2]);
    }

    /**
     * Returns the vertical field of view of a camera at a frame, in radians.
     *
     * @param rest field of view without animation
     */
    public double fieldOfView(int camera, double rest, int frame) {
        return at(Kind.FIELD_OF_VIEW, camera, new double[] {rest}, frame)[0];
    }

    private double[] at(Kind kind, int index, double[] rest, int frame) {
        KeyedValues values = keys.get(new AnimatedProperty(kind, index));
        return values == null ? rest : values.at(frame);
    }
}
