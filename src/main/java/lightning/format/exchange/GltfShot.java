package lightning.format.exchange;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.IntFunction;
import java.util.function.Supplier;
import lightning.base.math.Rgb;
import lightning.base.math.Transform;
import lightning.base.math.Vec3;
import lightning.base.text.RefusalException;
import lightning.base.work.Progress;
import lightning.format.exchange.assembly.FrameTracks;
import lightning.format.exchange.assembly.NearestAngles;
import lightning.format.exchange.assembly.NineDigits;
import lightning.format.exchange.assembly.SceneAssembler;
import lightning.format.exchange.assembly.TransformDecomposition;
import lightning.format.gltf.GltfAnimation;
import lightning.format.gltf.GltfLight;
import lightning.format.gltf.GltfNode;
import lightning.scene.Camera;
import lightning.scene.SceneElement;
import lightning.scene.light.Light;
import lightning.scene.light.LightAttribute;
import lightning.scene.node.NodeGroup;
import lightning.scene.node.SceneNode;
import lightning.scene.node.Shape;
import lightning.scene.shot.Shot;
import lightning.scene.shot.Track;
import lightning.scene.value.Placement;
import lightning.scene.value.SceneLimits;

/** Converter of a glTF file's animation to a shot, with a value at each frame. */
final class GltfShot {
    /** Maximum number of frames of all moving objects together: a few bytes can let thousands of objects move for thousands of frames. */
    private static final long MAX_STATES = 4_000_000;
    private static final List<LightAttribute<?>> LIGHT_ATTRIBUTES = List.of(LightAttribute.POSITION, LightAttribute.DIRECTION,
            LightAttribute.COLOR, LightAttribute.INTENSITY);

    private final SceneAssembler assembler;
    private final GltfAnimation animation;
    private final Progress progress;
    private final Map<Integer, GltfNode> parents = new HashMap<>();
    private final List<MovingNode> nodes = new ArrayList<>();
    private final List<MovingLight> lights = new ArrayList<>();
    private final List<Track> tracks = new ArrayList<>();
    private long keys;
    /** Frames at which flat nodes were looked at. */
    private long visits;

    /** Node that the scene shows as a shape or a group. */
    private record MovingNode(GltfNode node, SceneNode shown) {}

    /** Light of a scene, as its node and its light of the file have it without animation. */
    private record MovingLight(Light light, GltfNode node, GltfLight source, double quadratic) {}

    /** Camera for the transform of its node and its vertical field of view in radians. */
    interface CameraFactory {
        Camera create(Transform world, double fieldOfView);
    }

    /** @param roots nodes of the scene */
    GltfShot(SceneAssembler assembler, GltfAnimation animation, List<GltfNode> roots, Progress progress) {
        this.assembler = assembler;
        this.animation = animation;
        this.progress = progress;
        roots.forEach(this::addParents);
    }

    private void addParents(GltfNode node) {
        for (GltfNode child : node.children()) {
            if (child.index() >= 0) {
                parents.put(child.index(), node);
            }
            addParents(child);
        }
    }

    /** Returns whether a node moves in the scene. */
    boolean moves(GltfNode node) {
        Optional<GltfNode> above = Optional.of(node);
        while (above.isPresent() && !animation.moves(above.get())) {
            above = Optional.ofNullable(parents.get(above.get().index()));
        }
        return above.isPresent();
    }

    private Transform world(GltfNode node, int frame) {
        Transform world = animation.local(node, frame);
        for (GltfNode above = parents.get(node.index()); above != null; above = parents.get(above.index())) {
            world = animation.local(above, frame).times(world);
        }
        return world;
    }

    /** Adds a node that the scene shows as a shape or a group. */
    void addNode(GltfNode node, SceneNode shown) {
        if (animation.moves(node)) {
            nodes.add(new MovingNode(node, shown));
        }
    }

    /**
     * Adds a light.
     *
     * @param quadratic factor of its intensity in the file
     */
    void addLight(Light light, GltfNode node, GltfLight source, double quadratic) {
        if (moves(node) || animation.changesLight(source.index())) {
            lights.add(new MovingLight(light, node, source, quadratic));
        }
    }

    /** Returns whether the camera of a node changes. */
    boolean movesCamera(GltfNode node) {
        return moves(node) || animation.changesCamera(node.camera());
    }

    /**
     * Adds the keys of moving nodes, lights and the camera to the scene.
     *
     * @param cameraNode node of the scene's camera; empty if it is not of the file
     * @param fieldOfView its vertical field of view without animation, in radians
     */
    void finish(Optional<GltfNode> cameraNode, double fieldOfView, CameraFactory cameras) {
        Optional<GltfNode> camera = cameraNode.filter(this::movesCamera);
        long frames = animation.last() - animation.first() + 1L;
        if (frames * (nodes.size() + lights.size() + camera.stream().count()) > MAX_STATES) {
            assembler.notes.add("animation of more than " + MAX_STATES + " positions in all");
            return;
        }
        nodes.forEach(this::animateNode);
        lights.forEach(this::animateLight);
        Camera rest = assembler.camera.orElse(Camera.DEFAULT);
        camera.ifPresent(node -> addTracks("animated cameras that cannot be placed", () -> tracks().of(SceneElement.CAMERA,
                Camera.ATTRIBUTES, rest, states(frame -> rounded(cameras.create(world(node, frame),
                        animation.fieldOfView(node.camera(), fieldOfView, frame)))))));
        if (keys > Shot.MAX_KEYS) {
            assembler.notes.add("animation of more than " + Shot.MAX_KEYS + " keyframes");
        } else if (!tracks.isEmpty()) {
            assembler.shot = Optional.of(new Shot(animation.first(), animation.last(), animation.rate(), tracks));
        }
    }

    /** Returns the transform at the first frame in which a node that is flat without animation is not; empty for other nodes. */
    Optional<Transform> laterTransform(GltfNode node) {
        if (!animation.moves(node) || !TransformDecomposition.decompose(node.local()).isEmpty()) {
            return Optional.empty();
        }
        for (int frame = animation.first(); frame <= animation.last() && visits < MAX_STATES; frame++) {
            visits++;
            Transform local = animation.local(node, frame);
            if (!TransformDecomposition.decompose(local).isEmpty()) {
                return Optional.of(local);
            }
        }
        return Optional.empty();
    }

    private FrameTracks tracks() {
        return new FrameTracks(animation.first());
    }

    private <T> List<T> states(IntFunction<T> stateAt) {
        progress.checkCanceled("canceled while the animation was imported");
        List<T> states = new ArrayList<>();
        for (int frame = animation.first(); frame <= animation.last(); frame++) {
            states.add(stateAt.apply(frame));
        }
        return states;
    }

    /** Adds tracks; if a state is beyond the limits of a scene, adds a note instead. */
    private void addTracks(String note, Supplier<List<Track>> supplier) {
        if (keys > Shot.MAX_KEYS) {
            return;
        }
        try {
            List<Track> added = supplier.get();
            keys += added.stream().mapToLong(track -> track.keys().size()).sum();
            // Beyond the limit, only their number counts.
            if (keys <= Shot.MAX_KEYS) {
                tracks.addAll(added);
            }
        } catch (RefusalException | ArithmeticException e) {
            assembler.notes.add(note);
        }
    }

    private void animateNode(MovingNode moving) {
        // What is in a group does not matter for its own keys.
        SceneNode empty = switch (moving.shown) {
            case NodeGroup group -> group.withChildren(List.of());
            case Shape shape -> shape;
        };
        List<SceneNode> states = new ArrayList<>();
        addTracks("animated objects that cannot be placed", () -> {
            Placement[] previous = {empty.placement()};
            states.addAll(states(frame -> {
                List<Placement> placements = TransformDecomposition.decompose(animation.local(moving.node, frame));
                if (placements.size() != 1) {
                    // A scale of 0 is a usual way to hide an object.
                    return empty.withPlacement(previous[0]).withVisible(false);
                }
                previous[0] = NearestAngles.continued(previous[0], placements.getFirst());
                return empty.withPlacement(previous[0]).withVisible(true);
            }));
            return tracks().of(empty, empty, states);
        });
        assembler.notes.add("objects that are flat, too small or too large in some frames, hidden in these",
                states.stream().allMatch(SceneNode::visible) ? 0 : 1);
    }

    private void animateLight(MovingLight moving) {
        Light light = moving.light;
        boolean isRestored = assembler.restoredLights.contains(light.name());
        boolean isMoving = moves(moving.node);
        boolean hasKeys = animation.changesLight(moving.source.index());
        assembler.notes.add("animated intensities and colors of lights with settings of Lightning", isRestored && hasKeys ? 1 : 0);
        addTracks("animated lights that cannot be placed",
                () -> tracks().of(new SceneElement.OfLight(light.name()), LIGHT_ATTRIBUTES, light,
                        states(frame -> {
                            Light placed = isMoving ? placed(light, world(moving.node, frame)) : light;
                            return isRestored || !hasKeys ? placed : withValues(placed, moving, frame);
                        })));
    }

    private static Light placed(Light light, Transform world) {
        Light placed = light.type().hasPosition() ? light.withPosition(NineDigits.rounded(world.transformPoint(Vec3.ZERO))) : light;
        return light.type().hasDirection()
                ? placed.withDirection(NineDigits.rounded(world.transformVector(new Vec3(0, 0, -1)).normalized())) : placed;
    }

    private Light withValues(Light light, MovingLight moving, int frame) {
        Rgb color = animation.color(moving.source, frame);
        double max = SceneLimits.MAX_LIGHT_COLOR;
        return light.withColor(new Rgb(SceneAssembler.clamp(color.r(), max), SceneAssembler.clamp(color.g(), max),
                SceneAssembler.clamp(color.b(), max)))
                .withIntensity(SceneAssembler.clamp(animation.intensity(moving.source, frame) * moving.quadratic,
                        SceneLimits.MAX_INTENSITY));
    }

    private static Camera rounded(Camera camera) {
        return new Camera(NineDigits.rounded(camera.from()), NineDigits.rounded(camera.to()), NineDigits.rounded(camera.up()),
                NineDigits.rounded(camera.fov()), camera.shift(), camera.lens());
    }
}
