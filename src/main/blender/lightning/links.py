# SPDX-License-Identifier: Apache-2.0
"""Links between nodes, followed through reroutes and groups. A path of group nodes says where a socket is."""

# The most nodes, one after another, that are followed.
DEPTH = 40
CONSTANTS = ("ShaderNodeRGB", "ShaderNodeValue")


def source(socket, path: tuple):
    """Returns the output that gives a socket its value, and the groups around it; None for an unlinked one."""
    for _ in range(DEPTH):
        if not socket.is_linked:
            return None, path
        output = socket.links[0].from_socket
        node = output.node
        if node.bl_idname == "NodeReroute":
            socket = node.inputs[0]
        elif node.bl_idname == "NodeGroupInput" and path:
            socket, path = _same(path[-1].inputs, output), path[:-1]
        elif node.bl_idname == "ShaderNodeGroup" and node.node_tree is not None:
            ends = [inner for inner in node.node_tree.nodes if inner.bl_idname == "NodeGroupOutput"]
            if not ends:
                return None, path
            socket, path = _same(ends[0].inputs, output), (*path, node)
        else:
            return output, path
    return None, path


def outermost(socket, path: tuple):
    """Returns the socket that has the value of an unlinked one: that of a group's node for an input of the group."""
    while path and socket.is_linked and socket.links[0].from_node.bl_idname == "NodeGroupInput":
        socket = path[-1].inputs[socket.links[0].from_socket.identifier]
        path = path[:-1]
    return socket


def _same(sockets, socket):
    return next(s for s in sockets if s.identifier == socket.identifier)
